#include <fmt/format.h>

#include <filesystem>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/version.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/simulate/codegen/program_files.hpp"

namespace stepwire {

namespace {

/// What of the file is no part of the program, as words; empty where it is all there.
std::string left_out(const Work& work) {
  std::vector<std::string> parts;
  if (const auto& sweep = work.job.plan.diagram.sweep) {
    std::vector<std::string> names;
    for (const Sweep::Axis& axis : sweep->axes) names.push_back(axis.parameter);
    parts.push_back(
        fmt::format("the sweep of {0} (what is made has one value of each, the file's or that of --set)",
                    fmt::join(names, ", ")));
  }
  if (work.study) parts.emplace_back("the study");
  if (work.fit) parts.emplace_back("the fit");
  if (work.scene) parts.emplace_back("the scene");
  if (!work.figures.empty()) parts.emplace_back("figures");
  if (!work.claims.empty()) parts.emplace_back("claims");
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

ExitCode generate_files(const GenerateCommand& command, const Registry& registry) {
  const Work work = prepare(registry, command.file, command.options);
  const std::string name =
      command.name.empty() ? std::filesystem::path(command.file).stem().string() : command.name;
  const Tuning tuning = command.constant_parameters ? Tuning{} : tuning_of(work.job.plan);
  const auto files =
      program_files(work.job.plan, tuning, {name, "stepwire " + program_version(), command.c_interface});
  for (const auto& [path, text] : files) {
    const std::filesystem::path target = std::filesystem::path(command.out) / path;
    require_folder(target.parent_path().string());
    write_file(target.string(), text);
  }
  const std::string folder = shell_word(command.out), build = shell_word(command.out + "/build");
  say("{}: {} blocks written to {}; cmake -S {} -B {} && cmake --build {} makes a program\n", command.file,
      work.job.plan.blocks.size(), command.out, folder, build, build);
  for (const FixedParameter& fixed : tuning.fixed)
    say("  {} cannot be changed there: {}\n", fixed.name, fixed.reason);
  if (const std::string parts = left_out(work); !parts.empty()) fmt::print("  left out: {}\n", parts);
  fmt::print(
      "  the flags -ffp-contract=off and -fno-builtin-... of its CMakeLists.txt keep the bits of a run\n");
  return ExitCode::done;
}

}  // namespace stepwire

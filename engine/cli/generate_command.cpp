#include <fmt/format.h>

#include <filesystem>

#include "engine/cli/commands.hpp"
#include "engine/cli/console.hpp"
#include "engine/cli/version.hpp"
#include "engine/generate/program_files.hpp"
#include "engine/table/file.hpp"

namespace stepwire {

ExitCode generate_files(const GenerateCommand& command, const Registry& registry) {
  const Work work = prepare(registry, command.file, command.options);
  const std::string name = std::filesystem::path(command.file).stem().string();
  const auto files = program_files(work.job.plan, name, "stepwire " + program_version());
  for (const auto& [path, text] : files) {
    const std::filesystem::path target = std::filesystem::path(command.out) / path;
    require_folder(target.parent_path().string());
    write_file(target.string(), text);
  }
  say("{}: {} blocks written to {}; cmake -S {} -B {}/build && cmake --build {}/build makes a program\n",
      command.file, work.job.plan.blocks.size(), command.out, command.out, command.out, command.out);
  return ExitCode::done;
}

}  // namespace stepwire

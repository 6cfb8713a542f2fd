#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/app/cli/call_options.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/kept_inputs.hpp"
#include "engine/app/cli/model_call.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/fmu/unit_export.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/archive/archive.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/count.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/simulate/codegen/program_files.hpp"
#include "engine/simulate/codegen/tuning.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::cli {
namespace {

/// Options for exporting a diagram file as an FMI unit.
struct UnitCall {
  std::string file;
  std::string out;  ///< path of the unit
  std::string name;
  int version = 3;
};

namespace fs = std::filesystem;

/// Returns the icon as PNG; empty if the converter is missing.
std::string icon_of(const std::string& drawing, std::string& left_out) {
  if (const std::string problem = render::converter_problem(); !problem.empty()) {
    left_out = "the icon, since " + problem;
    return "";
  }
  constexpr int width = 256;
  return render::converted(drawing, render::PictureKind::png, width);
}

/// Draws the pictures of a unit. They are optional: after a failure `left_out` has the reason.
void draw(const UnitCall& call, const Registry& registry, fmu::ExportOptions& options,
          std::string& left_out) {
  try {
    diagram::Loader loader(registry);
    options.drawing = drawing::draw_picture(drawing::DrawnFile(loader, call.file).view().graph({}));
    options.icon = icon_of(options.drawing, left_out);
  } catch (const subprocess::ProcessStopped&) {
    throw;
  } catch (const std::exception& error) {
    left_out = fmt::format("the drawing: {}", error.what());
  }
}

/// Throws early if the target cannot be written.
void require_target(const std::string& out) {
  if (fs::is_directory(out))
    throw io::EnvironmentError(out + ": is a folder; a unit is a file, such as " + out + "/unit.fmu");
  const fs::path folder = fs::path(out).parent_path();
  if (!folder.empty()) io::require_folder(folder.string());
}

/// Exports the unit and prints notes on it.
ExitCode generate_unit(const UnitCall& call, const Registry& registry, const session::LoadedModel& model,
                       const codegen::Tuning& tuning) {
  require_target(call.out);
  keep_inputs(call.out, replay::files_read(model.job));
  const codegen::Compiler compiler;
  fmu::ExportOptions options{
      .version = call.version, .name = call.name, .made_by = "stepwire " + session::program_version()};
  std::string left_out;
  if (compiler.found()) draw(call, registry, options, left_out);
  const fmu::UnitExport made = fmu::export_unit(model.job.plan, tuning, options, compiler);
  io::write_file(call.out, archive::archive_bytes(made.files));
  say("{}: {} written to {}, a unit of FMI {} for co-simulation{}\n", call.file,
      text::counted(model.job.plan.blocks.size(), "block"), call.out, call.version,
      made.no_exchange.empty() ? " and model exchange" : "");
  if (!made.no_exchange.empty()) say("  no model exchange: {}\n", made.no_exchange);
  if (!left_out.empty()) say("  left out: {}\n", left_out);
  return ExitCode::done;
}

struct GenerateCall {
  std::string file;
  LoadWords words;
  std::string out;   ///< output folder
  std::string name;  ///< name of the program; empty: that of the file
  bool c_interface = false;
  bool constant_parameters = false;
  int fmi = 0;  ///< major version of FMI; 0: C++ sources
};

/// Lists the parts of the file that are not generated; empty if there are none.
std::string left_out(const session::LoadedModel& model) {
  std::vector<std::string> parts;
  if (const auto& sweep = model.job.plan.diagram.sweep) {
    std::vector<std::string> names;
    for (const diagram::Sweep::Axis& axis : sweep->axes)
      if (!axis.label) names.push_back(axis.parameter);
    parts.push_back(
        fmt::format("the sweep of {0} (what is made has one value of each, the file's or that of --set)",
                    fmt::join(names, ", ")));
  }
  if (model.job.plan.records_instants()) parts.emplace_back("rows beside those of ticks ('instants')");
  if (model.study) parts.emplace_back("the study");
  if (model.fit) parts.emplace_back("the fit");
  if (model.tune) parts.emplace_back("the tuning");
  if (model.scene) parts.emplace_back("the scene");
  if (!model.figures.empty()) parts.emplace_back("figures");
  if (!model.claims.empty()) parts.emplace_back("claims");
  return fmt::format("{}", fmt::join(parts, ", "));
}

ExitCode write_program(const GenerateCall& call, const std::string& name, const session::LoadedModel& model,
                       const codegen::Tuning& tuning) {
  const auto files = codegen::program_files(
      model.job.plan, tuning, {name, "stepwire " + session::program_version(), call.c_interface});
  const io::OwnedFolder owned(call.out, [&] { return replay::files_read(model.job); });
  for (const auto& [path, text] : files) {
    const std::filesystem::path target = std::filesystem::path(call.out) / path;
    io::require_folder(target.parent_path().string());
    io::write_file(target.string(), text);
  }
  const std::string folder = text::shell_word(call.out), build = text::shell_word(call.out + "/build");
  say("{}: {} written to {}; cmake -S {} -B {} -G Ninja && cmake --build {} makes a program\n", call.file,
      text::counted(model.job.plan.blocks.size(), "block"), call.out, folder, build, build);
  if (codegen::needs_eigen(files))
    say("  to compile it needs the headers of Eigen 3 (Debian package libeigen3-dev), for its solver or "
        "blocks\n");
  return ExitCode::done;
}

ExitCode generate(const GenerateCall& call, const Registry& registry) {
  const session::LoadedModel model = session::load_model(registry, call.file, load_options(call.words));
  const std::string name = call.name.empty() ? std::filesystem::path(call.file).stem().string() : call.name;
  const codegen::Tuning tuning =
      call.constant_parameters ? codegen::Tuning{} : codegen::tuning_of(model.job.plan);
  const ExitCode code = call.fmi == 0
                            ? write_program(call, name, model, tuning)
                            : generate_unit({call.file, call.out, name, call.fmi}, registry, model, tuning);
  for (const codegen::FixedParameter& fixed : tuning.fixed)
    say("  {} cannot be changed there: {}\n", fixed.name, fixed.reason);
  if (const std::string parts = left_out(model); !parts.empty()) say("  left out: {}\n", parts);
  say("  the flags -ffp-contract=off and -fno-builtin-... of its {}CMakeLists.txt keep the bits of a run\n",
      call.fmi == 0 ? "" : "sources/");
  return code;
}

Action declare_generate(CLI::App& verb) {
  const auto call = std::make_shared<GenerateCall>();
  verb.add_option("FILE", call->file, "a diagram file")->required();
  add_load_options(verb, call->words);
  verb.add_option("-o,--out", call->out, "folder for the program, or with --fmi the file of the unit")
      ->required();
  verb.add_option("--name", call->name, "name of the program, in place of that of the file");
  auto* c =
      verb.add_flag("--c-api", call->c_interface, "write a header and a source to call it from C as well");
  verb.add_option("--fmi", call->fmi,
                  "make a unit of FMI of this version, 3 or 2, with a binary for this machine")
      ->check(CLI::IsMember({3, 2}))
      ->excludes(c);
  verb.add_flag("--constant-parameters", call->constant_parameters,
                "write parameters as numbers into the code, which is faster; none can be changed then");
  return [call](const Registry& registry) { return generate(*call, registry); };
}

}  // namespace

Verb generate_verb() {
  return {"generate", "write a diagram as C++ that is built without stepwire, or as a unit of FMI",
          "Examples:\n  stepwire generate controller.yaml -o controller\n"
          "  stepwire generate controller.yaml --fmi 3 -o controller.fmu",
          declare_generate};
}

}  // namespace stepwire::cli

#include "engine/app/cli/generate_unit.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/kept_inputs.hpp"
#include "engine/app/fmu/unit_export.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/fmi/archive_bytes.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::cli {

namespace {

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

}  // namespace

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
  io::write_file(call.out, fmi::archive_bytes(made.files));
  say("{}: {} blocks written to {}, a unit of FMI {} for co-simulation{}\n", call.file,
      model.job.plan.blocks.size(), call.out, call.version,
      made.no_exchange.empty() ? " and model exchange" : "");
  if (!made.no_exchange.empty()) say("  no model exchange: {}\n", made.no_exchange);
  if (!left_out.empty()) say("  left out: {}\n", left_out);
  return ExitCode::done;
}

}  // namespace stepwire::cli

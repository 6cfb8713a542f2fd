#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/session/fault_json.hpp"
#include "engine/app/simulink/import.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::cli {
namespace {

namespace fs = std::filesystem;

struct ImportWords {
  std::string model, out;
  bool json = false, table = false;
};

std::string import_text(const simulink::ImportResult& result) {
  std::string text =
      fmt::format("{}: {} of {} blocks translated\n", result.model, result.translated, result.blocks);
  for (const simulink::Note& note : result.notes)
    text +=
        fmt::format("  {:<12} {}{}\n", simulink::word_of(note.kind),
                    note.block.empty() ? "" : text::visible(note.block) + ": ", text::visible(note.sentence));
  return text + fmt::format("  written to {}\n", fmt::join(result.files, ", "));
}

/// Returns the file to write: X.yaml in the present folder, if there is none yet.
std::string file_to_write(const ImportWords& words) {
  if (!words.out.empty()) return words.out;
  const std::string file = fs::path(words.model).stem().string() + ".yaml";
  std::error_code none;
  if (fs::exists(file, none))
    throw yaml::Error(yaml::Fault{{file, {}}, "", "is there already; name the file to write with -o", {}});
  return file;
}

ExitCode import_file(const ImportWords& words, const Registry& registry) {
  if (words.table) {
    put_data(simulink::translations_markdown());
    return ExitCode::done;
  }
  const simulink::ImportResult result = simulink::import_model({words.model, file_to_write(words)}, registry);
  if (words.json)
    put_json(result::json_of(result));
  else
    put_report(import_text(result), result.is_unfinished());
  return result.is_unfinished() ? ExitCode::fails : ExitCode::done;
}

Action declare_import(CLI::App& verb) {
  const auto words = std::make_shared<ImportWords>();
  CLI::Option* model = verb.add_option("FILE", words->model, "a Simulink model, .slx");
  verb.add_option("-o,--out", words->out, "diagram file to write; without it FILE.yaml in the present folder")
      ->option_text("NAME.yaml");
  verb.add_flag("--json", words->json, "print the report as JSON");
  verb.add_flag("--table", words->table, "print the translated blocks as Markdown")->excludes(model);
  return [words, model](const Registry& registry) {
    if (!words->table && model->empty()) {
      complain("import needs a FILE; see stepwire import --help\n");
      return ExitCode::wrong;
    }
    json::Json faults;
    const ExitCode code = guarded([&] { return import_file(*words, registry); }, &faults);
    if (words->json && faults.is_list()) put_json(json::Json::object().set("faults", std::move(faults)));
    return code;
  };
}

}  // namespace

Verb import_verb() {
  return {"import", "write a Simulink model as a diagram, and report what differs",
          "Example:\n  stepwire import motor.slx -o motor.yaml\n"
          "The exit code is 0 where the diagram is complete, 1 where blocks or values have to be written or "
          "the run "
          "differs from that of the model, and 2 where the model cannot be read.",
          declare_import};
}

}  // namespace stepwire::cli

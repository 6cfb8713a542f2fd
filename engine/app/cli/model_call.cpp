#include "engine/app/cli/model_call.hpp"

#include <CLI/CLI.hpp>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/guarded.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/session/fault_json.hpp"
#include "engine/base/data_file/reading_log.hpp"
#include "engine/model/diagram/unread.hpp"

namespace stepwire::cli {

using json::Json;

void add_model_options(CLI::App& verb, ModelCall& call) {
  verb.add_option("FILE", call.files, "diagram files")->required();
  add_load_options(verb, call.words);
  verb.add_option("--stop", call.words.stop, "stop time in place of the file's, e.g. 2s");
  verb.add_flag("--units", call.units, "print the unit of every wire");
  verb.add_flag("--json", call.json, "print the result as JSON");
}

namespace {

/// Loads a file and performs the action on it, with a log of the conversions of its data files.
ExitCode load_and_act(const Registry& registry, const std::string& file, const session::LoadOptions& options,
                      const ModelAction& action, Json& results) {
  const data_file::ReadingLog log;
  session::LoadedModel model = session::load_model(registry, file, options);
  return action(model, results);
}

}  // namespace

ExitCode each_model(const ModelCall& call, const Registry& registry, const ModelAction& action) {
  Json results = Json::list();
  session::LoadOptions options;
  try {
    options = load_options(call.words);
  } catch (const yaml::Error& error) {  // fault that concerns no single file
    if (call.json) put_json(results.push(Json::object().set("faults", session::faults_json(error.faults()))));
    throw;
  }
  options.study = call.study;
  options.threads = call.threads;
  ExitCode code = ExitCode::done;
  for (const std::string& file : call.files) {
    if (interrupted()) break;
    Json faults;
    const ExitCode one =
        guarded([&] { return load_and_act(registry, file, options, action, results); }, &faults);
    if (faults.is_list()) results.push(Json::object().set("file", file).set("faults", std::move(faults)));
    code = worst(code, one);
  }
  if (call.json) put_json(results);
  return interrupted() ? ExitCode::interrupted : code;
}

void print_notes(const session::LoadedModel& model) {
  for (const yaml::Fault& note : diagram::unread_blocks(model.job.plan.diagram))
    remark("note: {}\n", note.text());
}

}  // namespace stepwire::cli

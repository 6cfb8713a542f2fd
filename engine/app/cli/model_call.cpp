#include "engine/app/cli/model_call.hpp"

#include <CLI/CLI.hpp>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/session/fault_json.hpp"
#include "engine/base/data_file/reading_log.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/part_alone.hpp"
#include "engine/model/diagram/unread.hpp"

namespace stepwire::cli {

using json::Json;

void add_model_options(CLI::App& verb, ModelCall& call) {
  verb.add_option("FILE", call.files, "diagram files")->required();
  add_load_options(verb, call.words);
  verb.add_option("--stop", call.words.stop, "stop time in place of the file's, e.g. 2s");
  verb.add_flag("--units", call.units, "print the unit of every wire");
  verb.add_flag("--json", call.json, "print the result as JSON");
  verb.add_flag("--strict", call.strict, "exit with 1 where a note is printed, as where a claim fails");
}

namespace {

constexpr yaml::DocumentLimits large_limits{
    .bytes = std::size_t{512} << 20, .depth = 64, .nodes = 64'000'000};

diagram::Setting parse_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
    throw yaml::Error(
        yaml::Fault{{"--set " + text, {}}, "", "is no setting; write name=value, as --set rig.mass=2kg", {}});
  return {text.substr(0, equals), text.substr(equals + 1)};
}

void append_file(const std::string& path, std::vector<diagram::Setting>& settings) {
  const yaml::Document document = yaml::read_document(path);
  const char* const form = "a file of settings has lines such as 'rig.mass: 2 kg'";
  if (!document.root.is_map()) throw yaml::Error(yaml::Fault{{path, document.root.mark}, "", form, {}});
  for (const yaml::Entry& entry : document.root.entries) {
    if (!entry.value.is_scalar() && !entry.value.is_list())
      throw yaml::Error(yaml::Fault{{path, entry.value.mark}, entry.key, form, {}});
    const std::string text = entry.value.is_list() ? yaml::yaml_line(entry.value) : entry.value.text;
    settings.push_back({entry.key, text, path, entry.value.mark});
  }
}

/// Loads a file and performs the action on it, with a log of the conversions of its data files.
ExitCode load_and_act(const ModelCall& call, const Registry& registry, const std::string& file,
                      const session::LoadOptions& options, const ModelAction& action, Json& results) {
  const data_file::ReadingLog log;
  session::LoadedModel model = session::load_model(registry, file, options);
  const bool unread = !diagram::unread_blocks(model.job.plan.diagram).empty();
  return worst(action(model, results), call.code_of_notes(unread));
}

}  // namespace

void add_load_options(CLI::App& verb, LoadWords& words) {
  verb.add_option("--set", words.set,
                  "a parameter in place of the file's: name=value; reaches into parts (rig.mass=2kg)")
      ->allow_extra_args(false);
  verb.add_option("--set-from", words.set_from,
                  "a file with such values, as 'name: value'; fit and tune write one")
      ->type_name("FILE")
      ->allow_extra_args(false);
  verb.add_flag("--large", words.large, "read files above 8 MB, up to 512 MB");
}

session::LoadOptions load_options(const LoadWords& words) {
  session::LoadOptions options;
  for (const std::string& path : words.set_from) append_file(path, options.settings);
  for (const std::string& text : words.set) options.settings.push_back(parse_setting(text));
  if (!words.stop.empty()) options.stop = words.stop;
  if (words.large) options.limits = large_limits;
  return options;
}

/// Loads a file and acts on it. Reports an exception to the call, and throws it again.
static ExitCode act_on(const ModelCall& call, const Registry& registry, const std::string& file,
                       const session::LoadOptions& options, const ModelAction& action, Json& results) {
  try {
    return load_and_act(call, registry, file, options, action, results);
  } catch (const std::exception& error) {
    if (call.refused) call.refused(file, error.what());
    throw;
  }
}

/// True for a map without any key of a diagram. A file that cannot be read is none, so that its fault is
/// shown.
static bool is_other_file(const std::string& file) {
  try {
    return diagram::is_other_map(yaml::read_document(file).root);
  } catch (const yaml::Error&) {
    return false;
  }
}

/// Returns the diagrams among several files, and prints a note on each other one, as of `models/*.yaml`.
static std::vector<std::string> diagrams_of(const std::vector<std::string>& files) {
  std::vector<std::string> diagrams, others;
  for (const std::string& file : files)
    (files.size() > 1 && is_other_file(file) ? others : diagrams).push_back(file);
  if (diagrams.empty()) return files;
  for (const std::string& file : others) remark("note: {}: is left out; it has no key of a diagram\n", file);
  return diagrams;
}

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
  for (const std::string& file : diagrams_of(call.files)) {
    if (interrupted()) break;
    Json faults;
    const ExitCode one =
        guarded([&] { return act_on(call, registry, file, options, action, results); }, &faults);
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

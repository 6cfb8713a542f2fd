#include "engine/app/session/run_note.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "engine/app/session/outcome.hpp"
#include "engine/app/session/run_result.hpp"
#include "engine/base/io/file.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::session {

using json::Json;

namespace {

constexpr const char* head_keys[] = {"hash",   "title",     "step",       "stop",
                                     "solver", "functions", "parameters", "blocks"};
constexpr const char* sweep_keys[] = {"sweep", "keep", "kept", "recorded_runs", "runs"};

std::string flattened_path(const std::string& folder) {
  return (std::filesystem::path(folder) / replay::flattened_name).string();
}

bool is_empty_list(const Json* list) {
  return !list || list->is_null() || list->items().empty();
}

/// Returns the ticks of a run to its end; std::nullopt where a condition may end it before.
std::optional<std::int64_t> all_ticks(const diagram::Diagram& diagram) {
  const double ticks = diagram.stop / diagram.step;
  if (diagram.stop_when || std::abs(ticks - std::round(ticks)) > 1e-6) return std::nullopt;
  return std::llround(ticks);
}

}  // namespace

RunNote::RunNote(const std::string& folder)
    : folder_(folder), path_((std::filesystem::path(folder) / "run.json").string()) {
  text_ = io::read_file(path_);
  try {
    content_ = Json::parse(text_);
  } catch (const json::JsonError& error) {
    throw yaml::Error(yaml::Fault{{path_, {}}, "", yaml::Message(error.what()), {}});
  }
}

std::string RunNote::difference_from_folder(const Registry& registry) const {
  const std::string file = flattened_path(folder_);
  if (!std::filesystem::exists(file)) return "";
  diagram::Loader loader(registry, replay::wide_limits);
  const diagram::Diagram diagram = loader.load(file);
  Json computed = Json::object();
  computed.set("step", diagram.step).set("stop", diagram.stop);
  computed.set("solver", diagram.solver.empty() ? Json() : Json(diagram.solver));
  computed.set("functions", diagram.uses_libm ? "libm" : "portable");
  computed.set("hash", diagram::diagram_hash(diagram));
  const std::string found = difference(computed, std::string(replay::flattened_name) + " beside it");
  const Json* interrupted = content_.find("interrupted");
  const bool is_whole = is_empty_list(content_.find("sweep")) && is_empty_list(content_.find("faults")) &&
                        interrupted && !interrupted->as_flag().value_or(true);
  const auto ticks = is_whole ? all_ticks(diagram) : std::nullopt;
  return found.empty() && ticks ? difference_in_ticks(*ticks) : found;
}

std::string RunNote::difference_from(const LoadedModel& model) const {
  const Outcome none;
  const Json report = result::json_of(RunReport{&model, &none});
  Json computed = Json::object();
  const auto take = [&](const char* key) {
    if (const Json* found = report.find(key)) computed.set(key, *found);
  };
  for (const char* key : head_keys) take(key);
  if (!model.study)
    for (const char* key : sweep_keys) take(key);
  return difference(computed, model.file);
}

std::string RunNote::difference_in_ticks(std::int64_t ticks) const {
  return difference(Json::object().set("ticks", ticks), "the run");
}

std::string RunNote::other_hash(const std::string& file) const {
  return fmt::format(
      "{}: has the hash of another diagram than {} with the parameters of the run; the file, its data or "
      "run.json changed after the run",
      place("  \"hash\":"), file);
}

std::vector<diagram::Setting> RunNote::head_settings(const std::string& folder, const Registry& registry) {
  const std::string file = flattened_path(folder);
  if (!std::filesystem::exists(file)) return {};
  diagram::Loader loader(registry, replay::wide_limits);
  const yaml::Document document = loader.document(file);
  std::vector<diagram::Setting> settings;
  for (const char* key : {"step", "stop", "solver", "tolerance"})
    if (const yaml::Node* value = document.root.find(key))
      if (value->is_scalar()) settings.push_back({key, value->text});
  return settings;
}

std::string RunNote::difference(const Json& computed, const std::string& by) const {
  for (const auto& [key, value] : computed.members()) {
    const Json* there = content_.find(key);
    if (!there || there->text(-1) == value.text(-1)) continue;  // runs of older versions lack some
    const bool has_names = there->is_list() && value.is_list() && key == "parameters";
    const std::string in_list = has_names ? difference_in_list(key, *there, value, by) : "";
    if (!in_list.empty()) return in_list;
    if (!has_names)
      return fmt::format("{}: has \"{}\": {}, and {} has {}", place(fmt::format("  \"{}\":", key)), key,
                         there->text(-1), by, value.text(-1));
  }
  return "";
}

/// Compares the parameters one by one.
std::string RunNote::difference_in_list(const std::string& key, const Json& there, const Json& computed,
                                        const std::string& by) const {
  if (there.items().size() != computed.items().size())
    return fmt::format("{}: has {} {}, and {} has {}", place(fmt::format("  \"{}\":", key)),
                       there.items().size(), key, by, computed.items().size());
  for (std::size_t i = 0; i < there.items().size(); ++i) {
    const Json *name = there.items()[i].find("name"), *right = computed.items()[i].find("name");
    for (const auto& [member, value] : computed.items()[i].members()) {
      const Json* own = there.items()[i].find(member);
      if (!own || own->text(-1) == value.text(-1)) continue;
      const std::string shown = right ? right->text(-1) : "";
      return fmt::format("{}: the parameter {} has \"{}\": {}, and {} by {}",
                         place(fmt::format("      \"{}\":", member),
                               fmt::format("      \"name\": {}", name ? name->text(-1) : "")),
                         shown, member, own->text(-1), value.text(-1), by);
    }
  }
  return "";
}

std::string RunNote::place(const std::string& begin, const std::string& after) const {
  std::istringstream lines(text_);
  std::string line;
  bool is_behind = after.empty();
  for (int number = 1; std::getline(lines, line); ++number) {
    is_behind = is_behind || line.starts_with(after);
    if (is_behind && line.starts_with(begin)) return fmt::format("{}:{}", path_, number);
  }
  return path_;
}

}  // namespace stepwire::session

#include "engine/app/session/recorded_study.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "engine/app/session/rejudging.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::session {

using json::Json;

namespace {

constexpr const char* copy_name = "recorded.csv";

std::string path_in(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

/// Returns the name under which a signal is recorded; empty if it is not.
std::string recorded_name(const diagram::Diagram& diagram, const diagram::SignalRef& wanted) {
  for (const diagram::RecordRequest& record : diagram.records)
    for (const diagram::RecordedSignal& signal : record.signals)
      if (signal.signal.block == wanted.block && signal.signal.output == wanted.output) return signal.name;
  return {};
}

Json conditions_json(const study::StudyRequest& request) {
  Json all = Json::object();
  for (const study::StudyCondition& condition : request.conditions) {
    Json on = Json::object();
    for (const diagram::Setting& setting : condition.settings)
      on.set(setting.name, setting.value == "1" ? 1 : 0);
    all.set(condition.name, std::move(on));
  }
  return all;
}

Json published_json(const study::PublishedValues& published) {
  Json values = Json::object();
  for (const study::NamedValue& value : published.values) values.set(value.name, value.value);
  return Json::object().set("source", published.source).set("values", std::move(values));
}

Json published_json(const study::PublishedStudy& published) {
  Json json = Json::object(), examples = Json::list(), order = Json::list();
  if (!published.means.values.empty()) json.set("means", published_json(published.means));
  if (!published.probabilities.values.empty())
    json.set("probabilities", published_json(published.probabilities));
  for (const study::PublishedValues& one : published.examples) examples.push(published_json(one));
  for (const auto& names : published.order) order.push(Json::list_of(names));
  return json.set("examples", std::move(examples)).set("order", std::move(order));
}

/// Returns the section `study` for the same study of the copied trials. It is JSON, which is also YAML.
Json section_json(const study::StudyRequest& request, const diagram::Diagram& diagram) {
  Json section = Json::object()
                     .set("task", request.task)
                     .set("trials", copy_name)
                     .set("conditions", conditions_json(request))
                     .set("position", request.position)
                     .set("published", published_json(request.published));
  if (request.circle) section.set("circle", Json::object().set("of", request.circle->of));
  if (request.way_back)
    section.set("way_back", Json::object()
                                .set("position", recorded_name(diagram, request.way_back->position))
                                .set("direction", recorded_name(diagram, request.way_back->direction)));
  return section;
}

}  // namespace

void write_recorded(const std::string& folder, const LoadedModel& model) {
  replay::write_replay(folder, model.job.plan);
  io::write_file(path_in(folder, copy_name), io::read_file(model.study->trials));
  const std::string file = path_in(folder, replay::flattened_name);
  io::write_file(file, fmt::format("{}study: {}\n", io::read_file(file),
                                   section_json(*model.study, model.job.plan.diagram).text(-1)));
}

bool has_recorded(const std::string& folder, const Registry& registry) {
  const std::string file = path_in(folder, replay::flattened_name);
  if (!std::filesystem::exists(file)) return false;
  diagram::Loader loader(registry, replay::wide_limits);
  return loader.document(file).root.find("study") != nullptr;
}

std::string verify_recorded(const std::string& folder, const Registry& registry) {
  LoadOptions options;
  options.limits = replay::wide_limits;
  LoadedModel model = load_model(registry, path_in(folder, replay::flattened_name), options);
  const study::Experiments experiments{study::score_recorded(*model.study, model.job.plan.diagram)};
  const Outcome outcome = study_outcome(model, experiments);
  for (const StudyFile& one : study_texts(model, experiments, outcome))
    if (const auto line = first_difference(path_in(folder, one.name), one.text))
      return fmt::format("{}:{}: is '{}', but the recorded trials give '{}'", path_in(folder, one.name),
                         line->number, line->there, line->computed);
  return {};
}

}  // namespace stepwire::session

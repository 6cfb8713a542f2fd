#include "engine/app/studio/live/live_folder.hpp"

#include <filesystem>
#include <stdexcept>

#include "engine/app/session/version.hpp"
#include "engine/app/studio/live/recorded_so_far.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/model/diagram/variation.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::live {

namespace {

using json::Json;

constexpr const char* log_name = "/live.json";

/// Evaluator of the block values of the flattened diagram, which has no parameters, after each event.
class FlattenedValues {
 public:
  explicit FlattenedValues(const plan::Plan& plan) : plan_(plan), run_(plan), diagram_(plan.diagram) {}

  Json after(const LiveEvent& event) {
    apply(event, run_);
    run_.put_values(diagram_);
    Json values = Json::list();
    const diagram::Variation variation(plan_.diagram, {event.name});
    for (const diagram::Target& target : variation.targets())
      if (const auto value = diagram::flattened_value(diagram_, target, diagram::absolute_path))
        values.push(Json::object()
                        .set("name", diagram::name_of(diagram_, target))
                        .set("text", yaml::yaml_line(*value)));
    return values;
  }

 private:
  const plan::Plan& plan_;
  run::Executor run_;
  diagram::Diagram diagram_;
};

Json events_json(const plan::Plan& plan, const EventLog& log) {
  FlattenedValues values(plan);
  Json events = log.json(), all = Json::list();
  for (std::size_t i = 0; i < log.events().size(); ++i) {
    Json event = events.items()[i];
    if (!log.events()[i].is_input()) event.set("blocks", values.after(log.events()[i]));
    all.push(std::move(event));
  }
  return all;
}

/// Returns the plan of a loop up to its last tick, which may be after the stop time of the file.
plan::Plan plan_of_loop(const plan::Plan& plan, std::int64_t last) {
  diagram::Diagram diagram = plan.diagram;
  diagram.stop = plan.time_of(std::max<std::int64_t>(last, 1));
  diagram.stop_when.reset();
  return plan::make_plan(std::move(diagram));
}

void write_tables(const std::string& folder, LoadedRun& run, bool ended) {
  const auto recordings = recorded_rows(run.plan(), run.signals(), run.thread(), ended);
  for (std::size_t i = 0; i < recordings.size(); ++i)
    table::write_csv(folder + "/" + io::numbered("signals", i, ".csv"), recordings[i].table);
}

}  // namespace

void write_live_folder(const std::string& folder, LoadedRun& run) {
  const plan::Plan& plan = run.plan();
  if (plan.diagram.records.empty())
    throw std::runtime_error("the diagram records nothing that could be kept");
  io::OwnedFolder owned(folder, [&] { return replay::files_read(plan); });
  owned.reserve({"signals.csv", "live.json"});
  const auto timing = run.thread().timing();
  const RunStatus status = run.thread().status();
  const EventLog log = run.thread().log();
  replay::write_replay(folder, timing ? plan_of_loop(plan, status.tick) : plan);
  write_tables(folder, run,
               timing || status.state == RunStatus::State::ended);  // a loop ends at its present tick
  const Json note = Json::object()
                        .set("file", run.model().file)
                        .set("hash", run.model().hash)
                        .set("version", session::program_version())
                        .set("loop", timing.has_value())
                        .set("lost", timing ? *timing->find("lost") : Json(0))
                        .set("events", events_json(plan, log));
  io::write_file(folder + log_name, note.text() + "\n");
}

std::string folder_beside(const std::string& diagram) {
  return std::filesystem::path(diagram).replace_extension().string() + "-run";
}

bool is_live_folder(const std::string& folder) {
  std::error_code none;
  return std::filesystem::exists(folder + log_name, none);
}

}  // namespace stepwire::live

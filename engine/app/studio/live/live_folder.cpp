#include "engine/app/studio/live/live_folder.hpp"

#include <algorithm>
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
#include "engine/simulate/replay/run_replay.hpp"

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

[[noreturn]] void refuse_log(const std::string& file, const std::string& message) {
  throw yaml::Error(yaml::Fault{{file, {}}, "", message, {}});
}

std::string text_at(const Json& object, const char* key) {
  const Json* found = object.find(key);
  if (!found || !found->as_text()) throw std::runtime_error(std::string("a value has no '") + key + "'");
  return *found->as_text();
}

/// Event of a stored run, with the values of the flattened diagram that it set.
struct KeptEvent {
  LiveEvent event;
  std::vector<std::pair<std::string, std::string>> blocks;  ///< names and values of block parameters
};

class KeptLog {
 public:
  explicit KeptLog(const std::string& file) {
    try {
      read(Json::parse(io::read_file(file)));
    } catch (const std::runtime_error& error) {  // no JSON, or a member is missing
      refuse_log(file, error.what());
    }
    if (lost_ > 0.0)
      refuse_log(file, "the loop lost rows, with inputs that would be needed; it cannot be replayed");
  }

  const std::vector<KeptEvent>& events() const { return events_; }

 private:
  void read(const Json& note) {
    const Json *events = note.find("events"), *lost = note.find("lost");
    if (!events || !lost || !lost->as_number()) throw std::runtime_error("has no 'events' and 'lost'");
    lost_ = *lost->as_number();
    const EventLog log = EventLog::read(*events);
    for (std::size_t i = 0; i < log.events().size(); ++i) {
      events_.push_back({log.events()[i], {}});
      if (const Json* blocks = events->items()[i].find("blocks"))
        for (const Json& block : blocks->items())
          events_.back().blocks.emplace_back(text_at(block, "name"), text_at(block, "text"));
    }
  }

  double lost_ = 0.0;
  std::vector<KeptEvent> events_;
};

/// Observer that applies the events of a stored run.
class KeptReplay : public run::RunObserver {
 public:
  KeptReplay(const std::vector<KeptEvent>& events, std::string file)
      : events_(events), file_(std::move(file)) {}

  void begin(const run::ObservedRun& run) override {
    do_events(run.simulation, before_start);
    run.simulation.reset();
  }
  run::Flow before_tick(const run::ObservedRun& run) override {
    do_events(run.simulation, run.simulation.tick());
    return run::Flow::go_on;
  }

 private:
  void do_events(run::Executor& run, std::int64_t tick) {
    for (; next_ < events_.size() && events_[next_].event.tick <= tick; ++next_) {
      const KeptEvent& kept = events_[next_];
      kept.event.is_input() ? apply(kept.event, run) : set(kept, run);
    }
  }

  void set(const KeptEvent& kept, run::Executor& run) const {
    std::vector<std::string> names;
    std::vector<diagram::Assignment> values;
    for (const auto& [name, text] : kept.blocks) {
      names.push_back(name);
      values.push_back({name, diagram::value_of_text(text, file_), file_});
    }
    if (names.empty()) return;  // the event changes no block parameter
    if (run.set(diagram::Variation(run.plan().diagram, names), values) != run::Executor::Setting::done)
      refuse_log(file_, kept.event.name + ": " + run.structure_change());
  }

  const std::vector<KeptEvent>& events_;
  std::string file_;
  std::size_t next_ = 0;
};

std::vector<replay::Recorded> tables_of(const std::string& folder, const plan::Plan& plan,
                                        replay::Verification& result) {
  std::vector<replay::Recorded> tables;
  for (std::size_t i = 0; i < plan.diagram.records.size(); ++i) {
    const std::string file = folder + "/" + io::numbered("signals", i, ".csv");
    table::ColumnWords no_words;
    tables.push_back({file, table::read_csv(file, no_words), 1});
    replay::require_columns(tables.back(), plan, plan.diagram.records[i]);
    result.signals += tables.back().signals();
  }
  return tables;
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

replay::Verification verify_live(const std::string& folder, const Registry& registry,
                                 const std::atomic<bool>* interrupt) {
  const std::string file = folder + "/live.json";
  const KeptLog log(file);
  diagram::Loader loader(registry, replay::wide_limits);
  const plan::Plan plan =
      plan::make_plan(loader.load((std::filesystem::path(folder) / replay::flattened_name).string()));
  replay::Verification result;
  const std::vector<replay::Recorded> tables = tables_of(folder, plan, result);
  std::vector<replay::RecordedRows> rows;
  for (const replay::Recorded& table : tables) rows.push_back({&table, 0, table.table.rows()});
  KeptReplay kept(log.events(), file);
  run::RunOptions options;
  options.interrupt = interrupt;
  options.observers = {&kept};
  run::Executor run(plan);
  replay::replay_run(run, rows, options, result);
  return result;
}

}  // namespace stepwire::live

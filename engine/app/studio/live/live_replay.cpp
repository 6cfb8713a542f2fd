// Replay of a live run from the folder that write_live_folder() wrote.
#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "engine/app/studio/live/live_folder.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/model/diagram/variation.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/replay/run_replay.hpp"

namespace stepwire::live {

namespace {

using json::Json;

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

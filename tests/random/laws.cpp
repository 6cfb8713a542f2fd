#include "tests/random/laws.hpp"

#include <fmt/format.h>

#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "tests/random/law_tools.hpp"
#include "tests/random/reshaping.hpp"

namespace stepwire::random {

namespace {

/// A sketch that has to compute the same.
Verdict like(const Trial& trial, const Sketch& sketch, const OtherName& name = {}) {
  try {
    return verdict_of(difference(trial.expected, run(Loaded(*trial.registry, sketch, trial.folder)), name));
  } catch (const yaml::Error& error) {
    return verdict_of(std::string("it is refused: ") + error.what());
  }
}

Verdict again(const Trial& trial, BatchCode&) {
  return verdict_of(difference(trial.expected, run(*trial.loaded)));
}

/// A point of a sweep, cut out of the rows of all.
run::RunResult point_of(const run::RunResult& all, std::size_t point) {
  run::RunResult one;
  for (const record::Recording& recording : all.recordings) {
    record::Recording part = recording;
    const std::size_t first = recording.starts[point];
    const bool last = point + 1 == recording.starts.size();
    for (table::Column& column : part.table.columns) {
      const std::size_t end = last ? column.values.size() : recording.starts[point + 1];
      column.values = {column.values.begin() + static_cast<std::ptrdiff_t>(first),
                       column.values.begin() + static_cast<std::ptrdiff_t>(end)};
    }
    one.recordings.push_back(std::move(part));
  }
  return one;
}

Verdict set_alone(const Trial& trial, BatchCode&) try {
  if (trial.sketch.parameters.empty()) return skipped("it has no parameter");
  const Key& parameter = swept_parameter(trial);
  const auto values = swept_values(parameter);
  const run::RunResult all = one_by_one(*sweep_of(trial));
  for (std::size_t point = 0; point < values.size(); ++point) {
    run::RunResult own =
        run(Loaded(*trial.registry, trial.sketch, trial.folder, {{parameter.name, values[point]}}));
    own.faults.clear();
    const std::string text = difference(own, point_of(all, point));
    if (!text.empty()) return verdict_of(fmt::format("{}={}: {}", parameter.name, values[point], text));
  }
  return {};
} catch (const yaml::Error& error) {
  return skipped("a value of the sweep is refused");
}

Verdict flattened(const Trial& trial, BatchCode&) {
  const std::string text = diagram::flattened_text(trial.loaded->plan().diagram);
  try {
    return verdict_of(difference(trial.expected, run(Loaded(*trial.registry, text, trial.folder))));
  } catch (const yaml::Error& error) {
    return verdict_of(std::string("it is refused: ") + error.what());
  }
}

Verdict in_other_order(const Trial& trial, BatchCode&) {
  Dice dice = dice_of(trial, 1);
  return like(trial, shuffled(trial.sketch, dice));
}

/// Blocks of a solved loop may differ in their values alone. Then the order of their names decides at which
/// of them it is torn, and so its last bits: values may change within a sweep. The new names keep that order.
Verdict under_other_names(const Trial& trial, BatchCode&) {
  const OtherWord other_word = trial.loaded->plan().loops.empty() ? renamed_word : word_of_same_order;
  return like(trial, renamed(trial.sketch, other_word),
              [&](const std::string& column) { return with_words(column, other_word); });
}

Verdict beside_others(const Trial& trial, BatchCode&) {
  return like(trial, with_unrelated(trial.sketch));
}

Verdict in_a_part(const Trial& trial, BatchCode&) {
  Dice dice = dice_of(trial, 2);
  std::set<std::string> moved;
  for (const Entry& entry : trial.sketch.blocks)
    if (dice.chance(0.4)) moved.insert(entry.name);
  const Sketch sketch = with_part(trial.sketch, moved, "moved", "moved.yaml");
  if (moved.empty()) return skipped("it has no block that may be moved");
  return like(trial, sketch, [&](const std::string& column) {
    return with_references(column, moved, [](const std::string& reference) { return "moved." + reference; });
  });
}

/// Keeps a moment, and returns to it once from a later one.
class Returning : public run::RunObserver {
 public:
  Returning(std::int64_t keep_at, std::int64_t return_at) : keep_at_(keep_at), return_at_(return_at) {}

  run::Flow before_tick(const run::ObservedRun& run) override {
    if (!kept_ && run.simulation.tick() == keep_at_) kept_ = run.simulation.workspace();
    if (kept_ && !returned_ && run.simulation.tick() == return_at_) {
      run.simulation.restore(*kept_);
      returned_ = true;
    }
    return run::Flow::go_on;
  }
  bool returned() const { return returned_; }

 private:
  std::int64_t keep_at_, return_at_;
  std::optional<run::Workspace> kept_;
  bool returned_ = false;
};

Verdict returned(const Trial& trial, BatchCode&) {
  Dice dice = dice_of(trial, 3);
  const auto ticks = static_cast<std::size_t>(trial.expected.ticks);
  if (ticks < 3) return skipped("it ends at once");
  const auto from = static_cast<std::int64_t>(dice.below(ticks - 1));
  const auto at =
      from + 1 + static_cast<std::int64_t>(dice.below(ticks - static_cast<std::size_t>(from) - 1));
  Returning observer(from, at);
  run::RunOptions options;
  options.observers = {&observer};
  const run::RunResult result = run(*trial.loaded, options);
  if (!observer.returned()) return skipped("it ends before it returns");
  return verdict_of(difference(trial.expected, result));
}

/// Without the last row of the shorter run, which is recorded outside of the period.
void keep_common_rows(table::Table& longer, table::Table& shorter) {
  const std::size_t rows = shorter.rows() - 1;
  for (table::Table* table : {&longer, &shorter})
    for (table::Column& column : table->columns) column.values.resize(rows);
}

/// The rows up to a tick of a run whose stop is later.
Verdict ended_earlier(const Trial& trial, BatchCode&) {
  const std::int64_t half = trial.loaded->plan().steps / 2;
  if (trial.expected.ticks <= half) return skipped("it ends by itself");
  Sketch sketch = trial.sketch;
  for (Key& key : sketch.head)
    if (key.name == "stop")
      key.value = fmt::format("{} s", static_cast<double>(half) * trial.loaded->plan().diagram.step);
  const Loaded loaded(*trial.registry, sketch, trial.folder);
  run::RunResult expected = trial.expected, shorter = run(loaded);
  expected.faults.clear();  // it ends later
  // Steps are judged at the end and at quarters of a run, which are other ticks of a shorter one.
  std::erase_if(shorter.faults, [&](const run::RunFault& fault) {
    return shorter.ticks >= half ||
           fault.fault.text().find("equations do not let it grow") != std::string::npos;
  });
  for (std::size_t r = 0; r < shorter.recordings.size(); ++r)
    keep_common_rows(expected.recordings[r].table, shorter.recordings[r].table);
  return verdict_of(difference(expected, shorter));
}

/// Writes what `run` leaves of a run without a sweep.
void write_files(const std::string& folder, const run::Job& job, const run::RunResult& result) {
  replay::write_replay(folder, job);
  for (std::size_t r = 0; r < result.recordings.size(); ++r)
    io::write_file(fmt::format("{}/{}", folder, io::numbered("signals", r, ".csv")),
                   table::csv_text(result.recordings[r].table));
  io::write_file(folder + "/run.json", "{\"sweep\": [], \"runs\": 1, \"functions\": \"portable\"}\n");
}

Verdict verified(const Trial& trial, BatchCode&) {
  const subprocess::ScratchFolder folder;
  write_files(folder.path(), trial.loaded->all(), trial.expected);
  return verdict_of(replay::verify(folder.path(), *trial.registry).difference);
}

}  // namespace

void begin(Trial& trial) {
  trial.loaded = std::make_unique<Loaded>(*trial.registry, trial.sketch, trial.folder);
  trial.expected = run(*trial.loaded);
}

const std::vector<Law>& laws() {
  static const std::vector<Law> all = [] {
    std::vector<Law> laws{{"run again", again},
                          {"swept and set alone", set_alone},
                          {"flattened", flattened},
                          {"lines in another order", in_other_order},
                          {"blocks under other names", under_other_names},
                          {"beside unrelated blocks", beside_others},
                          {"blocks moved into a part", in_a_part},
                          {"returned to a kept moment", returned},
                          {"ended earlier", ended_earlier},
                          {"files verified", verified, 8},
                          {"step halved", step_halved, 7, 3}};
    laws.insert(laws.end(), laws_of_code().begin(), laws_of_code().end());
    return laws;
  }();
  return all;
}

}  // namespace stepwire::random

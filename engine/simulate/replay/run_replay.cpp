#include "engine/simulate/replay/run_replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/simulate/record/recorder.hpp"

namespace stepwire::replay {

namespace {

/// First difference in time among several tables.
class Earliest {
 public:
  void take(double time, std::string text) {
    if (!(time < time_)) return;
    time_ = time;
    text_ = std::move(text);
  }
  std::string text() const { return text_; }

 private:
  double time_ = std::numeric_limits<double>::infinity();
  std::string text_;
};

void compare(const RecordedRows& rows, const table::Table& computed, Earliest& earliest) {
  const Recorded& recorded = *rows.recorded;
  const std::size_t common = std::min(rows.count, computed.rows());
  for (std::size_t k = 0; k < common; ++k) {
    const auto number = [&](std::size_t i) { return computed.columns[i].values[k]; };
    if (const auto column = differing_column(recorded, rows.first + k, number)) {
      const std::size_t index = *column == 0 ? 0 : *column - recorded.first_signal + 1;
      return earliest.take(number(0),
                           difference_text(recorded, rows.first + k, *column, number(0), number(index)));
    }
  }
  if (rows.count <= common || common == 0) return;
  const double end = computed.columns.front().values[common - 1];
  earliest.take(std::nextafter(end, std::numeric_limits<double>::infinity()),
                extra_row_text(recorded, rows.first + common, end));
}

/// Returns the number of ticks until each table would have one more row, which shows whether the run
/// continued.
std::int64_t ticks_to_replay(const plan::Plan& plan, const std::vector<RecordedRows>& rows) {
  std::int64_t ticks = 0;
  if (plan.records_instants()) return plan.steps;
  for (std::size_t i = 0; i < rows.size(); ++i)
    ticks = std::max(ticks, static_cast<std::int64_t>(rows[i].count) *
                                record::ticks_between_rows(plan, plan.diagram.records[i]));
  return std::min(ticks, plan.steps);
}

/// Ends a run after a tick.
class UntilTick : public run::RunObserver {
 public:
  explicit UntilTick(std::int64_t last) : last_(last) {}
  run::Flow before_tick(const run::ObservedRun& run) override {
    return run.simulation.tick() > last_ ? run::Flow::stop : run::Flow::go_on;
  }

 private:
  std::int64_t last_;
};

}  // namespace

std::vector<std::size_t> replay_run(run::Executor& simulation, const std::vector<RecordedRows>& rows,
                                    const run::RunOptions& options, Verification& verification) {
  const plan::Plan& plan = simulation.plan();
  UntilTick until(ticks_to_replay(plan, rows));
  run::RunOptions own = options;
  own.observers.push_back(&until);
  run::TieredExecution interpreted(run::ExecutionMode::interpreted, nullptr, {}, 0.0);
  record::RunRecording recording(plan);
  const run::RunEnd end = run::run_simulation(simulation, recording.recorders(), own, interpreted, 0, 0);
  const std::vector<record::Recording> recordings = recording.take();
  verification.interrupted = verification.interrupted || end.interrupted;
  if (verification.interrupted) return {};
  std::vector<std::size_t> used;
  Earliest earliest;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const table::Table& computed = recordings[i].table;
    // A run that ended before its first row has no rows: these are of the next one.
    used.push_back(computed.rows() == 0 ? 0 : rows[i].count);
    verification.rows += used.back();
    const diagram::RecordRequest& request = plan.diagram.records[i];
    if (computed.rows() > used.back())
      verification.missing_rows +=
          (request.instants ? computed.rows() : record::max_rows(plan, request)) - used.back();
    compare({rows[i].recorded, rows[i].first, used.back()}, computed, earliest);
  }
  verification.difference = earliest.text();
  return used;
}

void replay_last_row(run::Executor& simulation, const std::vector<Recorded>& tables, std::size_t row,
                     const run::RunOptions& options, Verification& verification) {
  run::TieredExecution interpreted(run::ExecutionMode::interpreted, nullptr, {}, 0.0);
  record::RunRecording recording(simulation.plan(), true);
  const run::RunEnd end = run::run_simulation(simulation, recording.recorders(), options, interpreted, 0, 0);
  verification.interrupted = verification.interrupted || end.interrupted;
  if (verification.interrupted) return;
  Earliest earliest;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    ++verification.rows;
    if (!std::isnan(tables[i].times()[row]))
      compare({&tables[i], row, 1}, recording.finished()[i].table, earliest);
  }
  verification.difference = earliest.text();
}

}  // namespace stepwire::replay

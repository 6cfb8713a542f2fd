#include "engine/simulate/run/observed_ticks.hpp"

#include <algorithm>

#include "engine/simulate/record/recorder.hpp"

namespace stepwire::run {

ObservedTicks::ObservedTicks(const ObservedRun& run, std::span<RunObserver* const> observers, bool rows)
    : run_(run), observers_(observers) {
  if (!rows || observers.empty()) return;
  const plan::Plan& plan = run.simulation.plan();
  for (const diagram::RecordRequest& request : plan.diagram.records) {
    Row& row = rows_.emplace_back();
    row.instants = request.instants;
    row.every = record::ticks_between_rows(plan, request);
    for (const record::RecordedColumn& column : record::recorded_columns(plan, request))
      row.offsets.push_back(column.offset);
    row.numbers.resize(row.offsets.size());
  }
}

void ObservedTicks::begin() const {
  for (RunObserver* observer : observers_) observer->begin(run_);
}

Flow ObservedTicks::before_tick() const {
  Flow flow = Flow::go_on;
  for (RunObserver* observer : observers_) flow = std::max(flow, observer->before_tick(run_));
  return flow;
}

void ObservedTicks::evaluated(bool last) {
  for (RunObserver* observer : observers_) observer->evaluated(run_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (run_.simulation.tick() % rows_[i].every != 0 && !last) continue;
    if (rows_[i].instants && run_.simulation.has_stopped()) continue;  // shown at the event
    show(i, run_.simulation.values());
  }
}

void ObservedTicks::side(const double* values) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].instants) show(i, values);
}

void ObservedTicks::show(std::size_t recording, const double* values) {
  Row& row = rows_[recording];
  for (std::size_t k = 0; k < row.offsets.size(); ++k) row.numbers[k] = values[row.offsets[k]];
  for (RunObserver* observer : observers_) observer->row(run_, recording, row.numbers);
}

void ObservedTicks::end() const {
  for (RunObserver* observer : observers_) observer->end(run_);
}

}  // namespace stepwire::run

#include "engine/simulate/record/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/model/diagram/units.hpp"
#include "engine/model/plan/element_slot.hpp"

namespace stepwire::record {

std::vector<RecordedColumn> recorded_columns(const plan::Plan& plan, const diagram::RecordRequest& request) {
  std::vector<RecordedColumn> columns;
  columns.push_back({"time", unit::parse_unit("s")->dimension, plan::Layout::time});
  for (const diagram::RecordedSignal& signal : request.signals) {
    const plan::SignalSlot slot = plan.slot(signal.signal);
    for (Eigen::Index k = 0; k < slot.size; ++k)
      columns.push_back(
          {plan::element_name(signal.name, slot, k), plan.dimension(plan::element_of(signal.signal, slot, k)),
           slot.offset + static_cast<std::size_t>(k), diagram::zeros_if_kelvin(plan.diagram, signal.signal)});
  }
  return columns;
}

std::int64_t ticks_between_rows(const plan::Plan& plan, const diagram::RecordRequest& request) {
  return request.every ? static_cast<std::int64_t>(std::llround(*request.every / plan.diagram.step)) : 1;
}

std::size_t max_rows(const plan::Plan& plan, const diagram::RecordRequest& request) {
  const std::int64_t every = ticks_between_rows(plan, request);
  return static_cast<std::size_t>((plan.steps + every - 1) / every + 1);
}

std::vector<table::Column> empty_columns(const plan::Plan& plan, const diagram::RecordRequest& request) {
  std::vector<table::Column> columns;
  for (RecordedColumn& column : recorded_columns(plan, request))
    columns.push_back({std::move(column.name), column.dimension ? unit::si_name(*column.dimension) : "", {}});
  return columns;
}

Recorder::Recorder(const plan::Plan& plan, const diagram::RecordRequest& request,
                   std::vector<double*> columns)
    : time_of_(plan.tick_times),
      every_(ticks_between_rows(plan, request)),
      ready_(std::numeric_limits<std::size_t>::max()),
      instants_(request.instants),
      columns_(std::move(columns)) {
  for (const RecordedColumn& column : recorded_columns(plan, request)) offsets_.push_back(column.offset);
}

Recorder::Recorder(const plan::Plan& plan, const diagram::RecordRequest& request,
                   std::vector<std::vector<double>*> columns)
    : Recorder(plan, request, std::vector<double*>(columns.size())) {
  grown_ = std::move(columns);
  ready_ = 0;
  if (!instants_) make_ready(1);
}

void Recorder::make_ready(std::size_t rows) {
  const std::size_t needed = filled_ + rows;
  if (needed <= ready_) return;
  ready_ = std::max(needed, std::min(grown_.front()->capacity(), ready_ + rows_at_once));
  for (std::size_t i = 0; i < grown_.size(); ++i) {
    grown_[i]->resize(ready_);
    columns_[i] = grown_[i]->data();
  }
}

void Recorder::record_side(const double* values, Side side) {
  const bool again = filled_ > 0 && side_ == side && grown_.front()->back() == values[offsets_.front()];
  if (side == Side::after && again) return;
  for (std::size_t i = 0; i < offsets_.size(); ++i) grown_[i]->push_back(values[offsets_[i]]);
  side_ = side;
  ++filled_;
}

/// Returns to the row just before the tick, which is kept.
void Recorder::go_back_to_side(std::int64_t tick) {
  const std::vector<double>& times = *grown_.front();
  const auto at = std::ranges::lower_bound(times, time_of_(tick));
  filled_ = std::min(times.size(), static_cast<std::size_t>(at - times.begin()) + (tick > 0 ? 1 : 0));
  side_ = Side::before;
  for (std::vector<double>* column : grown_) column->resize(filled_);
}

RunRecording::RunRecording(const plan::Plan& plan, bool last_only) {
  recordings_.resize(plan.diagram.records.size());  // elements must not move, since recorders refer to them
  for (std::size_t i = 0; i < recordings_.size(); ++i) {
    const diagram::RecordRequest& request = plan.diagram.records[i];
    recordings_[i].table.columns = empty_columns(plan, request);
    add(plan, request, recordings_[i], request.instants ? 0 : last_only ? 1 : max_rows(plan, request));
    if (last_only) recorders_.back().keep_last_only();
  }
}

void RunRecording::add(const plan::Plan& plan, const diagram::RecordRequest& request, Recording& recording,
                       std::size_t rows) {
  std::vector<std::vector<double>*> columns;
  for (table::Column& column : recording.table.columns) {
    column.values.reserve(rows);
    columns.push_back(&column.values);
  }
  recorders_.emplace_back(plan, request, std::move(columns));
}

const std::vector<Recording>& RunRecording::finished() {
  for (std::size_t i = 0; i < recordings_.size(); ++i)
    for (table::Column& column : recordings_[i].table.columns) column.values.resize(recorders_[i].rows());
  return recordings_;
}

// Columns keep their capacity and address.
void RunRecording::restart() {
  for (Recorder& recorder : recorders_) recorder.restart();
}

// Takes the recordings. Unused capacity was never written, so it occupies no memory in long columns.
std::vector<Recording> RunRecording::take() {
  for (std::size_t i = 0; i < recordings_.size(); ++i)
    for (table::Column& column : recordings_[i].table.columns) {
      column.values.resize(recorders_[i].rows());
      const std::size_t capacity = column.values.capacity();
      if (capacity <= Recorder::rows_at_once && column.values.size() < capacity / 2)
        column.values.shrink_to_fit();
    }
  return std::move(recordings_);
}

}  // namespace stepwire::record

#include "engine/simulate/record/recorder.hpp"

#include <cmath>
#include <utility>

#include "engine/model/plan/element_slot.hpp"

namespace stepwire::record {

std::vector<RecordedColumn> recorded_columns(const plan::Plan& plan, const diagram::RecordRequest& request) {
  std::vector<RecordedColumn> columns;
  columns.push_back({"time", unit::parse_unit("s")->dimension, plan::Layout::time});
  for (const diagram::RecordedSignal& signal : request.signals) {
    const plan::SignalSlot slot = plan.slot(signal.signal);
    const auto dimension = plan.dimension(signal.signal);
    for (Eigen::Index k = 0; k < slot.size; ++k)
      columns.push_back(
          {plan::element_name(signal.name, slot, k), dimension, slot.offset + static_cast<std::size_t>(k)});
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
    : every_(ticks_between_rows(plan, request)), columns_(std::move(columns)) {
  for (const RecordedColumn& column : recorded_columns(plan, request)) offsets_.push_back(column.offset);
}

RunRecording::RunRecording(const plan::Plan& plan, bool last_only) {
  for (const diagram::RecordRequest& request : plan.diagram.records) {
    rows_.push_back(last_only ? 1 : max_rows(plan, request));
    Recording recording;
    recording.table.columns = empty_columns(plan, request);
    std::vector<double*> columns;
    for (table::Column& column : recording.table.columns) {
      column.values.resize(rows_.back());
      columns.push_back(column.values.data());
    }
    recordings_.push_back(std::move(recording));
    recorders_.emplace_back(plan, request, std::move(columns));
    if (last_only) recorders_.back().keep_last_only();
  }
}

const std::vector<Recording>& RunRecording::finished() {
  for (std::size_t i = 0; i < recordings_.size(); ++i)
    for (table::Column& column : recordings_[i].table.columns) column.values.resize(recorders_[i].rows());
  return recordings_;
}

// Columns keep what they have room for, and stay where they are.
void RunRecording::restart() {
  for (std::size_t i = 0; i < recordings_.size(); ++i) {
    for (table::Column& column : recordings_[i].table.columns) column.values.resize(rows_[i]);
    recorders_[i].go_back_to(0);
  }
}

std::vector<Recording> RunRecording::take() {
  for (std::size_t i = 0; i < recordings_.size(); ++i)
    for (table::Column& column : recordings_[i].table.columns) {
      column.values.resize(recorders_[i].rows());
      if (column.values.size() < column.values.capacity() / 2) column.values.shrink_to_fit();
    }
  return std::move(recordings_);
}

}  // namespace stepwire::record

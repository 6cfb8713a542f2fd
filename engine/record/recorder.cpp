#include "engine/record/recorder.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stepwire {

std::vector<RecordedColumn> recorded_columns(const Plan& plan, const RecordRequest& request) {
  std::vector<RecordedColumn> columns;
  columns.push_back({"time", parse_unit("s")->dimension, Layout::time});
  for (const RecordedSignal& signal : request.signals) {
    const SignalSlot slot = plan.slot(signal.signal);
    const auto dimension = plan.dimension(signal.signal);
    for (Eigen::Index k = 0; k < slot.size; ++k)
      columns.push_back({slot.size == 1 ? signal.name : fmt::format("{}.{}", signal.name, k + 1), dimension,
                         slot.offset + static_cast<std::size_t>(k)});
  }
  return columns;
}

std::int64_t ticks_between_rows(const Plan& plan, const RecordRequest& request) {
  return request.every ? static_cast<std::int64_t>(std::llround(*request.every / plan.diagram.step)) : 1;
}

Recorder::Recorder(const Plan& plan, const RecordRequest& request)
    : every_(ticks_between_rows(plan, request)) {
  for (RecordedColumn& column : recorded_columns(plan, request)) {
    offsets_.push_back(column.offset);
    names_.push_back({std::move(column.name), column.dimension ? si_name(*column.dimension) : ""});
  }
  rows_.assign(static_cast<std::size_t>(plan.steps / every_ + 1) * offsets_.size(), 0.0);
}

Recording Recorder::take() const {
  Recording recording;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    Column column{names_[i].name, names_[i].unit, {}};
    column.values.reserve(filled_);
    for (std::size_t row = 0; row < filled_; ++row) column.values.push_back(rows_[row * offsets_.size() + i]);
    recording.table.columns.push_back(std::move(column));
  }
  return recording;
}

}  // namespace stepwire

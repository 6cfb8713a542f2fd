#include "engine/simulate/run/kept_rows.hpp"

#include <algorithm>
#include <limits>

namespace stepwire::run {

namespace {

constexpr double no_row = std::numeric_limits<double>::quiet_NaN();

/// The recording of one run, in which each row has the swept parameters as well.
record::Recording with_swept(const record::Recording& run, const SweptColumns& swept, std::size_t point) {
  record::Recording all = run;
  swept.add(all, point);
  return all;
}

double last_time(const record::Recording& run) {
  const std::vector<double>& time = run.table.columns.front().values;
  return time.empty() ? no_row : time.back();
}

}  // namespace

KeptRows::KeptRows(const Job& job, const SweptColumns& swept, const RunNumbers* numbers)
    : job_(job), swept_(swept), numbers_(numbers), made_(job.points.size(), 0), idle_(job.family->size()) {
  const std::size_t recordings = numbers ? 1 : job.plan.diagram.records.size();
  for (std::size_t r = 0; r < recordings; ++r) {
    record::Recording& kept = kept_.emplace_back();
    auto& columns = kept.table.columns;
    if (numbers) {
      columns = numbers->columns;
      columns.insert(columns.begin(), {"time", "s", {}});
    } else {
      columns = record::empty_columns(job.plan, job.plan.diagram.records[r]);
    }
    columns.insert(columns.begin() + 1, swept.columns().begin(), swept.columns().end());
    kept.categories = swept.categories();
    for (table::Column& column : columns) column.values.resize(job.points.size(), no_row);
  }
}

std::unique_ptr<record::RunRecording> KeptRows::take(std::size_t member) {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_[member].empty()) {
      auto recording = std::move(idle_[member].back());
      idle_[member].pop_back();
      return recording;
    }
  }
  return std::make_unique<record::RunRecording>(job_.family->plan(member), numbers_ == nullptr);
}

void KeptRows::done(std::size_t point, bool whole, std::unique_ptr<record::RunRecording> recorded) {
  const std::vector<record::Recording>& run = recorded->finished();
  if (numbers_)
    keep_numbers(point, whole, run);
  else
    keep_last(point, whole, run);
  made_[point] = 1;
  recorded->restart();
  const std::lock_guard lock(mutex_);
  idle_[job_.points[point].member].push_back(std::move(recorded));
}

void KeptRows::begin_row(record::Recording& kept, std::size_t point) const {
  const std::vector<double> numbers = swept_.numbers(point);
  for (std::size_t axis = 0; axis < numbers.size(); ++axis)
    kept.table.columns[1 + axis].values[point] = numbers[axis];
}

void KeptRows::keep_last(std::size_t point, bool whole, const std::vector<record::Recording>& run) {
  const std::size_t swept = swept_.columns().size();
  for (std::size_t r = 0; r < kept_.size(); ++r) {
    begin_row(kept_[r], point);
    const auto& columns = run[r].table.columns;
    for (std::size_t c = 0; whole && run[r].table.rows() > 0 && c < columns.size(); ++c)
      kept_[r].table.columns[c == 0 ? 0 : c + swept].values[point] = columns[c].values.back();
  }
}

void KeptRows::keep_numbers(std::size_t point, bool whole, const std::vector<record::Recording>& run) {
  auto& columns = kept_.front().table.columns;
  begin_row(kept_.front(), point);
  if (!whole) return;
  std::vector<record::Recording> all;
  for (const record::Recording& one : run) all.push_back(with_swept(one, swept_, point));
  const std::vector<double> numbers = numbers_->of(all);
  columns.front().values[point] = run.empty() ? no_row : last_time(run.front());
  const std::size_t first = 1 + swept_.columns().size();
  for (std::size_t i = 0; i < numbers.size(); ++i) columns[first + i].values[point] = numbers[i];
}

/// An interrupted sweep has no rows of what it has not made.
void KeptRows::drop_missing(record::Recording& kept) const {
  for (table::Column& column : kept.table.columns) {
    std::size_t end = 0;
    for (std::size_t point = 0; point < made_.size(); ++point)
      if (made_[point]) column.values[end++] = column.values[point];
    column.values.resize(end);
  }
}

std::vector<record::Recording> KeptRows::recordings() {
  for (record::Recording& kept : kept_) {
    if (std::ranges::find(made_, 0) != made_.end()) drop_missing(kept);
    kept.starts.resize(kept.table.rows());
    for (std::size_t run = 0; run < kept.starts.size(); ++run) kept.starts[run] = run;
  }
  return std::move(kept_);
}

}  // namespace stepwire::run

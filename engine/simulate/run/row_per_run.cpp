#include "engine/simulate/run/row_per_run.hpp"

#include "engine/simulate/run/number_row.hpp"

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

bool keeps_a_row(const Job& job, const RunNumbers* numbers) {
  return numbers || job.plan.diagram.sweep->keep == diagram::Sweep::Keep::final;
}

std::vector<record::Recording> empty_recordings(const plan::Plan& plan, const RunNumbers* numbers) {
  std::vector<record::Recording> recordings;
  if (numbers) {
    recordings.emplace_back().table.columns = numbers->columns;
    recordings.back().table.columns.insert(recordings.back().table.columns.begin(), {"time", "s", {}});
    return recordings;
  }
  for (const diagram::RecordRequest& request : plan.diagram.records)
    recordings.emplace_back().table.columns = record::empty_columns(plan, request);
  return recordings;
}

RowMaker::RowMaker(const Job& job, const SweptColumns& swept, const RunNumbers* numbers)
    : job_(job), swept_(swept), numbers_(numbers), idle_(job.family->size()) {}

std::unique_ptr<record::RunRecording> RowMaker::take(std::size_t member) {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_[member].empty()) {
      auto recording = std::move(idle_[member].back());
      idle_[member].pop_back();
      return recording;
    }
  }
  return std::make_unique<record::RunRecording>(job_.family->plan(member),
                                                numbers_ == nullptr && keeps_a_row(job_, nullptr));
}

std::vector<record::Recording> RowMaker::row_of(std::size_t point, bool whole,
                                                std::unique_ptr<record::RunRecording> recorded) {
  const std::vector<record::Recording>& run = recorded->finished();
  auto row = numbers_ ? number_row(point, whole, run) : last_row(point, whole, run);
  recorded->restart();
  const std::lock_guard lock(mutex_);
  idle_[job_.points[point].member].push_back(std::move(recorded));
  return row;
}

std::vector<record::Recording> RowMaker::last_row(std::size_t point, bool whole,
                                                  const std::vector<record::Recording>& run) const {
  auto row = empty_recordings(job_.plan_of(point), nullptr);
  for (std::size_t r = 0; r < row.size(); ++r)
    for (std::size_t c = 0; c < row[r].table.columns.size(); ++c) {
      const bool is_there = whole && run[r].table.rows() > 0;
      row[r].table.columns[c].values = {is_there ? run[r].table.columns[c].values.back() : no_row};
    }
  return row;
}

std::vector<record::Recording> RowMaker::number_row(std::size_t point, bool whole,
                                                    const std::vector<record::Recording>& run) const {
  if (!whole) {
    auto row = empty_recordings(job_.plan_of(point), numbers_);
    for (table::Column& column : row.front().table.columns) column.values = {no_row};
    return row;
  }
  std::vector<record::Recording> all;
  for (const record::Recording& one : run) all.push_back(with_swept(one, swept_, point));
  return {run::number_row(*numbers_, all)};
}

record::Recording number_row(const RunNumbers& numbers, std::span<const record::Recording> run) {
  record::Recording row;
  row.table.columns.push_back({"time", "s", {run.empty() ? no_row : last_time(run.front())}});
  const std::vector<double> values = numbers.of(run);
  for (std::size_t i = 0; i < values.size(); ++i) {
    row.table.columns.push_back(numbers.columns[i]);
    row.table.columns.back().values = {values[i]};
  }
  return row;
}

RowPerRun::RowPerRun(const Job& job, const SweptColumns& swept, const RunNumbers* numbers)
    : swept_(swept), made_(job.points.size(), 0), kept_(empty_recordings(job.plan, numbers)) {
  for (record::Recording& kept : kept_) {
    auto& columns = kept.table.columns;
    columns.insert(columns.begin() + 1, swept.columns().begin(), swept.columns().end());
    kept.categories = swept.categories();
    for (table::Column& column : columns) column.values.resize(job.points.size(), no_row);
  }
}

void RowPerRun::put(std::size_t point, const std::vector<record::Recording>& row) {
  const std::vector<double> numbers = swept_.numbers(point);
  for (std::size_t r = 0; r < kept_.size(); ++r) {
    auto& columns = kept_[r].table.columns;
    for (std::size_t axis = 0; axis < numbers.size(); ++axis) columns[1 + axis].values[point] = numbers[axis];
    const auto& from = row[r].table.columns;
    for (std::size_t c = 0; c < from.size(); ++c)
      columns[c == 0 ? 0 : c + numbers.size()].values[point] = from[c].values.front();
  }
  made_[point] = 1;
}

/// An interrupted sweep has no rows of what it has not made.
void RowPerRun::drop_missing(record::Recording& kept) const {
  for (table::Column& column : kept.table.columns) {
    std::size_t end = 0;
    for (std::size_t point = 0; point < made_.size(); ++point)
      if (made_[point]) column.values[end++] = column.values[point];
    column.values.resize(end);
  }
}

std::vector<record::Recording> RowPerRun::recordings() {
  for (record::Recording& kept : kept_) {
    if (std::ranges::find(made_, 0) != made_.end()) drop_missing(kept);
    kept.starts.resize(kept.table.rows());
    for (std::size_t run = 0; run < kept.starts.size(); ++run) kept.starts[run] = run;
  }
  return std::move(kept_);
}

}  // namespace stepwire::run

#include "engine/simulate/run/row_per_run.hpp"

#include "engine/simulate/run/number_row.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

namespace stepwire::run {

namespace {

constexpr double no_row = std::numeric_limits<double>::quiet_NaN();

/// Returns a copy of the recording of one run, with the swept parameters as columns.
record::Recording with_swept(const record::Recording& run, const SweptColumns& swept, std::size_t point) {
  record::Recording all = run;
  swept.add(all, point);
  return all;
}

/// Returns the index of a point among the recorded ones; std::nullopt for any other point.
std::optional<std::size_t> place_of(const std::vector<std::size_t>& recorded_points, std::size_t point) {
  const auto found = std::ranges::lower_bound(recorded_points, point);
  if (found == recorded_points.end() || *found != point) return std::nullopt;
  return static_cast<std::size_t>(found - recorded_points.begin());
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

std::vector<record::Recording> empty_recordings(const Job& job, std::size_t point,
                                                const RunNumbers* numbers) {
  auto recordings = empty_recordings(job.plan_of(point), numbers);
  if (!numbers || !job.plan.diagram.sweep->records_rows_of(point)) return recordings;
  std::ranges::move(empty_recordings(job.plan_of(point), nullptr), std::back_inserter(recordings));
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
  if (numbers_ && job_.plan.diagram.sweep->records_rows_of(point))
    row.insert(row.end(), run.begin(), run.end());
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
    : job_(job),
      swept_(swept),
      made_(job.points.size(), 0),
      kept_(empty_recordings(job.plan, numbers)),
      recorded_points_(job.plan.diagram.sweep->recorded_points()),
      recorded_(recorded_points_.size()) {
  for (record::Recording& kept : kept_) {
    auto& columns = kept.table.columns;
    columns.insert(columns.begin() + 1, swept.columns().begin(), swept.columns().end());
    kept.categories = swept.categories();
    for (table::Column& column : columns) column.values.resize(job.points.size(), no_row);
  }
}

void RowPerRun::put(std::size_t point, std::vector<record::Recording> row) {
  const std::vector<double> numbers = swept_.numbers(point);
  for (std::size_t r = 0; r < kept_.size(); ++r) {
    auto& columns = kept_[r].table.columns;
    for (std::size_t axis = 0; axis < numbers.size(); ++axis) columns[1 + axis].values[point] = numbers[axis];
    const auto& from = row[r].table.columns;
    for (std::size_t c = 0; c < from.size(); ++c)
      columns[c == 0 ? 0 : c + numbers.size()].values[point] = from[c].values.front();
  }
  made_[point] = 1;
  const auto place = place_of(recorded_points_, point);
  if (!place) return;
  row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(kept_.size()));
  recorded_[*place] = std::move(row);
}

/// Removes the rows of points that were not run because the sweep was interrupted.
void RowPerRun::drop_missing(record::Recording& kept) const {
  for (table::Column& column : kept.table.columns) {
    std::size_t end = 0;
    for (std::size_t point = 0; point < made_.size(); ++point)
      if (made_[point]) column.values[end++] = column.values[point];
    column.values.resize(end);
  }
}

/// Pools the recordings of one request over all points whose rows are kept.
record::Recording RowPerRun::pooled(std::size_t request) {
  record::Recording all;
  all.starts.clear();
  for (std::size_t i = 0; i < recorded_points_.size(); ++i) {
    auto& recorded = recorded_[i];
    if (recorded.empty()) recorded = empty_recordings(job_.plan_of(recorded_points_[i]), nullptr);
    swept_.add(recorded[request], recorded_points_[i]);
    append_runs(all, std::move(recorded[request]));
  }
  return all;
}

std::vector<record::Recording> RowPerRun::recordings() {
  for (record::Recording& kept : kept_) {
    if (std::ranges::find(made_, 0) != made_.end()) drop_missing(kept);
    kept.starts.resize(kept.table.rows());
    for (std::size_t run = 0; run < kept.starts.size(); ++run) kept.starts[run] = run;
  }
  for (std::size_t r = 0; !recorded_points_.empty() && r < job_.plan.diagram.records.size(); ++r)
    kept_.push_back(pooled(r));
  return std::move(kept_);
}

}  // namespace stepwire::run

#include "engine/analyse/study/path_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::study {
namespace {

std::string name_of(const Trial& trial) {
  return fmt::format("subject {}, task {}, condition {}", trial.subject, trial.task, trial.condition);
}

/// Calls `score`; an exception gets the name of the trial.
template <class Score>
auto scored(const Trial& trial, const Score& score) {
  try {
    return score();
  } catch (const statistics::StatisticsError& error) {
    throw statistics::StatisticsError(fmt::format("{}: {}", name_of(trial), error.what()));
  }
}

std::vector<const Trial*> of_task(const std::vector<Trial>& trials, const std::string& task) {
  std::vector<const Trial*> result;
  for (const Trial& trial : trials)
    if (trial.task == task) result.push_back(&trial);
  if (result.empty())
    throw statistics::StatisticsError(fmt::format("there are no trials of task '{}'", task));
  return result;
}

/// Begins the row of a trial whose first `points` points are scored.
PathError started(const Trial& trial, std::size_t points, double time_limit, PathErrors& errors) {
  PathError row{trial.subject, trial.condition};
  row.duration = trial.time[points - 1] - trial.time.front();
  if (row.duration > time_limit)
    errors.warnings.push_back(
        fmt::format("{} lasted {:.3g} s; the thesis repeats trials that last longer than {:g} s",
                    name_of(trial), row.duration, time_limit));
  return row;
}

void normalise(PathErrors& errors) {
  double largest = 0.0;
  for (const PathError& row : errors.rows) largest = std::max(largest, row.error);
  for (PathError& row : errors.rows) row.normalised = largest > 0.0 ? row.error / largest : 0.0;
}

const char* word_of(statistics::CircleFit fit) {
  switch (fit) {
    case statistics::CircleFit::kasa:
      return "Kasa";
    case statistics::CircleFit::pratt:
      return "Pratt";
    case statistics::CircleFit::taubin:
      return "Taubin";
    case statistics::CircleFit::geometric:
      break;
  }
  return "geometric";
}

const statistics::Circle& circle_of(const PathErrors& errors, const Trial& trial, const CircleTask& task) {
  const auto found = errors.circles.find(trial.subject);
  if (found != errors.circles.end()) return found->second;
  throw statistics::StatisticsError(fmt::format(
      "{}: there is no drawing under '{}' to which a circle could be fitted", name_of(trial), task.of));
}

std::vector<std::string> column_of(const PathErrors& errors, std::string PathError::*member) {
  std::vector<std::string> words;
  for (const PathError& row : errors.rows) words.push_back(row.*member);
  return words;
}

table::Column numbers(const PathErrors& errors, const std::string& name, const std::string& unit,
                      double PathError::*member, double scale = 1.0) {
  table::Column column{name, unit, {}};
  for (const PathError& row : errors.rows) column.values.push_back(scale * (row.*member));
  return column;
}

table::Column levels(const statistics::Factor& factor) {
  table::Column column{factor.name, "", {}};
  for (const std::size_t level : factor.level) column.values.push_back(static_cast<double>(level));
  return column;
}

table::Column counts(const PathErrors& errors) {
  table::Column column{"points", "", {}};
  for (const PathError& row : errors.rows) column.values.push_back(static_cast<double>(row.points));
  return column;
}

std::vector<std::string> presence(const PathErrors& errors, const std::vector<Condition>& conditions,
                                  const std::string& factor) {
  std::vector<std::string> words;
  for (const PathError& row : errors.rows) {
    const auto found = std::ranges::find(conditions, row.condition, &Condition::name);
    if (found == conditions.end()) {
      std::vector<std::string> names;
      for (const Condition& condition : conditions) names.push_back(condition.name);
      throw statistics::StatisticsError(fmt::format("subject {}: '{}' is no condition; there are: {}",
                                                    row.subject, row.condition, fmt::join(names, ", ")));
    }
    words.emplace_back(found->has(factor) ? "present" : "absent");
  }
  return words;
}

}  // namespace

std::vector<std::string> PathErrors::conditions() const {
  return statistics::make_factor("condition", column_of(*this, &PathError::condition)).levels;
}

PathErrors circle_errors(const std::vector<Trial>& trials, const CircleTask& task) {
  const auto chosen = of_task(trials, task.task);
  PathErrors errors{task.task, "m^2", "m", {}, {}, {}, {}};
  errors.rule = fmt::format(
      "sum of squared radial deviations of all recorded points from the circle fitted to the drawing {} ({} "
      "fit), "
      "over the largest",
      task.of, word_of(task.fit));
  for (const Trial* trial : chosen)
    if (trial->condition == task.of)
      errors.circles[trial->subject] =
          scored(*trial, [&] { return statistics::fit_circle(trial->points, task.fit); });
  for (const Trial* trial : chosen) {
    PathError row = started(*trial, trial->time.size(), task.time_limit, errors);
    row.error = row.raw = statistics::squared_deviations(trial->points, circle_of(errors, *trial, task));
    row.points = trial->time.size();
    row.deviation = std::sqrt(row.error / static_cast<double>(row.points));
    row.length = statistics::path_length(trial->points);
    errors.rows.push_back(std::move(row));
  }
  normalise(errors);
  return errors;
}

PathErrors return_errors(const std::vector<Trial>& trials, const statistics::WayBack& way_back,
                         const ReturnTask& task) {
  PathErrors errors{task.task, "m", "rad", {}, {}, {}, {}};
  errors.rule = fmt::format(
      "sum of step lengths times their angles from the way back (equations 17 to 25), resampled by {} in "
      "steps of "
      "{:g} mm; raw: the recorded points; over the largest",
      task.resampling.rule == statistics::Resampling::Rule::arc_length ? "arc length" : "chord",
      1e3 * task.resampling.spacing);
  for (const Trial* trial : of_task(trials, task.task)) {
    const statistics::ReturnError found =
        scored(*trial, [&] { return statistics::return_error(trial->points, way_back, task.resampling); });
    PathError row = started(*trial, static_cast<std::size_t>(found.raw_points), task.time_limit, errors);
    row.error = found.error;
    row.raw = found.raw;
    row.points = static_cast<std::size_t>(found.points);
    row.length = found.length;
    row.deviation = found.error / found.length;
    errors.rows.push_back(std::move(row));
  }
  normalise(errors);
  return errors;
}

table::Table error_table(const PathErrors& errors, table::ColumnWords& words) {
  const auto subject = statistics::make_factor("subject", column_of(errors, &PathError::subject));
  const auto condition = statistics::make_factor("condition", column_of(errors, &PathError::condition));
  words["subject"] = subject.levels;
  words["condition"] = condition.levels;
  const bool square = errors.unit == "m^2", length = errors.deviation_unit == "m";
  const double scale = square ? 1e6 : 1e3;
  const std::string unit = square ? "mm^2" : "mm";
  return {{levels(subject), levels(condition), numbers(errors, "error", unit, &PathError::error, scale),
           numbers(errors, "normalised", "", &PathError::normalised),
           numbers(errors, "raw", unit, &PathError::raw, scale),
           numbers(errors, "deviation", length ? "mm" : "rad", &PathError::deviation, length ? 1e3 : 1.0),
           numbers(errors, "length", "mm", &PathError::length, 1e3),
           numbers(errors, "duration", "s", &PathError::duration), counts(errors)}};
}

record::Recording error_recording(const PathErrors& errors) {
  const auto subject = statistics::make_factor("subject", column_of(errors, &PathError::subject));
  const auto condition = statistics::make_factor("condition", column_of(errors, &PathError::condition));
  record::Recording recording;
  table::Column time{"time", "s", {}};
  for (std::size_t i = 0; i < errors.rows.size(); ++i) time.values.push_back(static_cast<double>(i));
  recording.table.columns = {time,
                             levels(subject),
                             levels(condition),
                             numbers(errors, "error", errors.unit, &PathError::error),
                             numbers(errors, "normalised", "1", &PathError::normalised),
                             numbers(errors, "raw", errors.unit, &PathError::raw),
                             numbers(errors, "deviation", errors.deviation_unit, &PathError::deviation),
                             numbers(errors, "length", "m", &PathError::length),
                             numbers(errors, "duration", "s", &PathError::duration)};
  recording.categories = {{"subject", subject.levels}, {"condition", condition.levels}};
  if (errors.circles.empty()) return recording;
  for (const char* name : circle_columns) recording.table.columns.push_back({name, "m", {}});
  for (const PathError& row : errors.rows) {
    const statistics::Circle& circle = errors.circles.at(row.subject);
    const std::array values{circle.centre.x(), circle.centre.y(), circle.radius};
    for (std::size_t i = 0; i < values.size(); ++i)
      recording.table.columns[recording.table.columns.size() - values.size() + i].values.push_back(values[i]);
  }
  return recording;
}

bool Condition::has(const std::string& factor) const {
  return std::ranges::find(factors, std::pair(factor, true)) != factors.end();
}

std::vector<std::string> factors_of(const std::vector<Condition>& conditions) {
  std::vector<std::string> names;
  for (const Condition& condition : conditions)
    for (const auto& [name, present] : condition.factors)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  std::erase_if(names, [&](const std::string& name) {
    const auto on = std::ranges::count_if(conditions, [&](const Condition& one) { return one.has(name); });
    return on == 0 || on == std::ssize(conditions);
  });
  return names;
}

statistics::Observations observations(const PathErrors& errors, const std::vector<Condition>& conditions) {
  statistics::Observations result{"normalised path error of task " + errors.task, {}, {}};
  for (const PathError& row : errors.rows) result.values.push_back(row.normalised);
  for (const std::string& name : factors_of(conditions)) {
    statistics::Factor factor = statistics::make_factor(name, presence(errors, conditions, name));
    if (factor.levels.size() > 1) result.factors.push_back(std::move(factor));
  }
  result.factors.push_back(statistics::make_factor("condition", column_of(errors, &PathError::condition)));
  result.factors.push_back(statistics::make_factor("subject", column_of(errors, &PathError::subject), true));
  return result;
}

}  // namespace stepwire::study

#include "engine/study/study_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/record/recorder.hpp"

namespace stepwire {

namespace {

const std::vector<std::pair<const char*, bool FeedbackCondition::*>> factors{
    {"haptic", &FeedbackCondition::haptic},
    {"visual", &FeedbackCondition::visual},
    {"guiding path", &FeedbackCondition::guiding_path}};

/// "p.guiding_path" of "guiding path".
std::string column_of(const std::string& start, std::string factor) {
  std::replace(factor.begin(), factor.end(), ' ', '_');
  return start + factor;
}

/// The feedbacks in which the conditions differ.
std::vector<std::string> factors_of(const StudyRequest& request) {
  std::vector<std::string> result;
  for (const auto& [name, member] : factors) {
    const auto& all = request.conditions;
    const auto on = std::count_if(all.begin(), all.end(),
                                  [&, m = member](const StudyCondition& one) { return one.feedback.*m; });
    if (on > 0 && on < static_cast<std::ptrdiff_t>(all.size())) result.emplace_back(name);
  }
  return result;
}

double nan() {
  return std::numeric_limits<double>::quiet_NaN();
}

void fill(Column column, std::size_t rows, double value, Recording& recording, std::size_t at) {
  column.values.assign(rows, value);
  recording.table.columns.insert(recording.table.columns.begin() + static_cast<std::ptrdiff_t>(at),
                                 std::move(column));
}

/// What a recorded trial has of the columns that a run would record.
Recording recording_of(const Trial& trial, const StudyRequest& request, const Plan& plan, std::size_t r) {
  Recording recording;
  for (const RecordedColumn& recorded : recorded_columns(plan, plan.diagram.records[r])) {
    Column column{recorded.name, recorded.dimension ? si_name(*recorded.dimension) : "",
                  std::vector<double>(trial.time.size(), nan())};
    if (recorded.name == "time") column.values = trial.time;
    for (const Eigen::Index axis : {0, 1})
      if (r == request.recording && recorded.name == fmt::format("{}.{}", request.position, axis + 1))
        for (std::size_t row = 0; row < column.values.size(); ++row)
          column.values[row] = trial.points(axis, static_cast<Eigen::Index>(row));
    recording.table.columns.push_back(std::move(column));
  }
  return recording;
}

std::size_t place_in(const std::vector<std::string>& all, const std::string& name) {
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), name) - all.begin());
}

void append(Recording& all, Recording one) {
  if (all.table.columns.empty()) {
    all = std::move(one);
    all.starts = {0};
    return;
  }
  all.starts.push_back(all.table.rows());
  for (std::size_t i = 0; i < all.table.columns.size(); ++i) {
    const auto& values = one.table.columns[i].values;
    all.table.columns[i].values.insert(all.table.columns[i].values.end(), values.begin(), values.end());
  }
}

/// Words of the request's own order, in place of those in the order of the rows.
void number_words(const StudyRequest& request, const Experiment& experiment, Recording& recording) {
  const std::vector<std::string> subjects = request.subject_names(), conditions = request.condition_names();
  recording.words = {{"subject", subjects}, {"condition", conditions}};
  for (Column& column : recording.table.columns) {
    if (column.name != "subject" && column.name != "condition") continue;
    const bool person = column.name == "subject";
    for (std::size_t row = 0; row < column.values.size(); ++row)
      column.values[row] =
          static_cast<double>(person ? place_in(subjects, experiment.errors.rows[row].subject)
                                     : place_in(conditions, experiment.errors.rows[row].condition));
  }
}

Recording pooled(const Experiment& experiment, const StudyRequest& request, const Plan& plan, std::size_t r) {
  const std::vector<std::string> subjects = request.subject_names(), conditions = request.condition_names();
  Recording all;
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    const Trial& trial = experiment.trials[i];
    Recording one = experiment.runs.empty() ? recording_of(trial, request, plan, r)
                                            : experiment.runs[i].result.recordings[r];
    const std::size_t rows = one.table.rows();
    fill({"subject", "", {}}, rows, static_cast<double>(place_in(subjects, trial.subject)), one, 1);
    fill({"condition", "", {}}, rows, static_cast<double>(place_in(conditions, trial.condition)), one, 2);
    append(all, std::move(one));
  }
  all.words = {{"subject", subjects}, {"condition", conditions}};
  return all;
}

Recording outcome_recording(const Experiment& experiment, const StudyRequest& request) {
  Recording recording;
  recording.table.columns.push_back({"time", "s", {0.0}});
  for (const NamedValue& value : outcome(experiment, request))
    recording.table.columns.push_back({value.name, "", {value.value}});
  return recording;
}

}  // namespace

std::vector<std::string> outcome_columns(const StudyRequest& request) {
  std::vector<std::string> columns;
  for (const std::string& condition : request.condition_names()) columns.push_back("mean." + condition);
  for (const char* start : {"p.", "p_subject."})
    for (const std::string& factor : factors_of(request)) columns.push_back(column_of(start, factor));
  return columns;
}

void add_study_names(const StudyRequest& request, Names& names) {
  std::size_t records = 0;
  for (const RecordedName& name : names.columns)
    if (name.recording) records = std::max(records, *name.recording + 1);
  const auto add = [&](const std::string& name, const char* unit, std::optional<std::size_t> recording) {
    if (names.find(name))
      throw Error(Fault{request.place,
                        "study",
                        fmt::format("makes a column '{}', and so does the file; record that signal under "
                                    "another name: {{NAME: {}}}",
                                    name, name),
                        {}});
    names.columns.push_back({name, parse_unit(unit)->dimension, recording});
  };
  add("subject", "1", {});
  names.columns.back().words = request.subject_names();
  add("condition", "1", {});
  names.columns.back().words = request.condition_names();
  const bool circle = request.task == "1";
  add("error", circle ? "m^2" : "m", records);
  add("normalised", "1", records);
  add("raw", circle ? "m^2" : "m", records);
  add("deviation", circle ? "m" : "rad", records);
  add("length", "m", records);
  add("duration", "s", records);
  for (const std::string& column : outcome_columns(request)) add(column, "1", records + 1);
}

std::vector<NamedValue> outcome(const Experiment& experiment, const StudyRequest& request) {
  std::vector<NamedValue> values;
  for (const std::string& name : outcome_columns(request)) values.push_back({name, nan()});
  const auto set = [&](const std::string& name, double value) {
    for (NamedValue& one : values)
      if (one.name == name) one.value = value;
  };
  if (!experiment.analysis) return values;
  const TaskAnalysis& analysis = *experiment.analysis;
  for (const NamedValue& mean : analysis.means) set("mean." + mean.name, mean.value);
  for (const auto& [start, anova] :
       {std::pair{"p.", &analysis.additive}, std::pair{"p_subject.", &analysis.with_subject}})
    for (const AnovaRow& row : anova->terms) set(column_of(start, row.name), row.p);
  return values;
}

std::vector<Recording> study_recordings(const Experiment& experiment, const StudyRequest& request,
                                        const Plan& plan) {
  std::vector<Recording> recordings;
  for (std::size_t r = 0; r < plan.diagram.records.size(); ++r)
    recordings.push_back(pooled(experiment, request, plan, r));
  recordings.push_back(error_recording(experiment.errors));
  number_words(request, experiment, recordings.back());
  recordings.back().starts.clear();  // each trial is a run of one row, whose mean is no mean over time
  for (std::size_t row = 0; row < experiment.errors.rows.size(); ++row)
    recordings.back().starts.push_back(row);
  recordings.push_back(outcome_recording(experiment, request));
  return recordings;
}

}  // namespace stepwire

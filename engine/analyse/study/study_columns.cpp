#include "engine/analyse/study/study_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/pooling.hpp"

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
    append_runs(all, std::move(one));
  }
  all.words = {{"subject", subjects}, {"condition", conditions}};
  return all;
}

/// The errors, with the words of the request; each trial is a run of one row, whose mean is no mean over
/// time.
Recording errors_of(const Experiment& experiment, const StudyRequest& request) {
  Recording recording = error_recording(experiment.errors);
  number_words(request, experiment, recording);
  recording.starts.clear();
  for (std::size_t row = 0; row < experiment.errors.rows.size(); ++row) recording.starts.push_back(row);
  return recording;
}

/// Means over the trials of each condition, by names such as "deviation.HV".
std::vector<NamedValue> mean_deviations(const Experiment& experiment, const StudyRequest& request) {
  std::vector<NamedValue> values;
  for (const std::string& condition : request.condition_names()) {
    double sum = 0.0, count = 0.0;
    for (const PathError& row : experiment.errors.rows)
      if (row.condition == condition) sum += row.deviation, ++count;
    values.push_back({"deviation." + condition, count > 0.0 ? sum / count : nan()});
  }
  return values;
}

/// What each feedback adds to the normalised error, by names such as "effect.haptic".
std::vector<NamedValue> effects_of(const Experiment& experiment, const StudyRequest& request) {
  std::vector<NamedValue> values;
  for (const std::string& factor : factors_of(request))
    values.push_back({column_of("effect.", factor),
                      experiment.analysis ? value_of(experiment.analysis->effects, factor) : nan()});
  return values;
}

std::vector<NamedValue> published_means(const StudyRequest& request) {
  std::vector<NamedValue> values;
  for (const std::string& condition : request.condition_names())
    values.push_back({"thesis." + condition, value_of(request.published.means.values, condition)});
  return values;
}

Recording outcome_recording(const Experiment& experiment, const StudyRequest& request) {
  Recording recording;
  recording.table.columns.push_back({"time", "s", {0.0}});
  const auto add = [&](const std::vector<NamedValue>& values, const std::string& unit) {
    for (const NamedValue& value : values)
      recording.table.columns.push_back({value.name, unit, {value.value}});
  };
  add(outcome(experiment, request), "");
  add(effects_of(experiment, request), "");
  add(mean_deviations(experiment, request), experiment.errors.deviation_unit);
  add(published_means(request), "");
  return recording;
}

/// Adds the columns of a study to the names that figures and claims know.
class StudyNames {
 public:
  StudyNames(const StudyRequest& request, SymbolTable& names) : request_(request), names_(names) {
    for (const RecordedName& name : names.columns)
      if (name.recording) records_ = std::max(records_, *name.recording + 1);
  }

  /// Those that each recording has besides.
  void add_trials() {
    add("subject", "1", {});
    names_.columns.back().words = request_.subject_names();
    add("condition", "1", {});
    names_.columns.back().words = request_.condition_names();
  }

  /// Of the recording of errors, a row for each trial.
  void add_errors() {
    add("error", circle_ ? "m^2" : "m", records_);
    add("normalised", "1", records_);
    add("raw", circle_ ? "m^2" : "m", records_);
    add("deviation", circle_ ? "m" : "rad", records_);
    add("length", "m", records_);
    add("duration", "s", records_);
    if (!circle_) return;
    for (const char* column : circle_columns) add(column, "m", records_);
  }

  /// Of the recording of one row for the whole study.
  void add_outcome() {
    const std::size_t outcome = records_ + 1;
    for (const std::string& column : outcome_columns(request_)) add(column, "1", outcome);
    for (const std::string& factor : factors_of(request_)) add(column_of("effect.", factor), "1", outcome);
    for (const std::string& condition : request_.condition_names())
      add("deviation." + condition, circle_ ? "m" : "rad", outcome);
    for (const std::string& condition : request_.condition_names()) add("thesis." + condition, "1", outcome);
  }

 private:
  void add(const std::string& name, const char* unit, std::optional<std::size_t> recording) {
    if (names_.find(name))
      throw Error(Fault{request_.place,
                        "study",
                        fmt::format("makes a column '{}', and so does the file; record that signal under "
                                    "another name: {{NAME: {}}}",
                                    name, name),
                        {}});
    names_.columns.push_back({name, parse_unit(unit)->dimension, recording});
  }

  const StudyRequest& request_;
  SymbolTable& names_;
  const bool circle_ = request_.task == "1";
  std::size_t records_ = 0;  ///< recordings of the diagram itself
};

}  // namespace

std::vector<std::string> outcome_columns(const StudyRequest& request) {
  std::vector<std::string> columns;
  for (const std::string& condition : request.condition_names()) columns.push_back("mean." + condition);
  for (const char* start : {"p.", "p_subject."})
    for (const std::string& factor : factors_of(request)) columns.push_back(column_of(start, factor));
  return columns;
}

void add_study_names(const StudyRequest& request, SymbolTable& names) {
  StudyNames study(request, names);
  study.add_trials();
  study.add_errors();
  study.add_outcome();
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

std::vector<Recording> study_recordings(const Experiments& experiments, const StudyRequest& request,
                                        const Job& job) {
  const std::size_t records = job.plan.diagram.records.size();
  const SweptColumns swept(job);
  std::vector<Recording> recordings(records + 2);
  for (std::size_t study = 0; study < experiments.size(); ++study) {
    const Experiment& experiment = experiments[study];
    const auto add = [&](std::size_t r, Recording one) {
      swept.add(one, study);
      append_runs(recordings[r], std::move(one));
    };
    for (std::size_t r = 0; r < records; ++r) add(r, pooled(experiment, request, job.plan, r));
    add(records, errors_of(experiment, request));
    add(records + 1, outcome_recording(experiment, request));
  }
  return recordings;
}

}  // namespace stepwire

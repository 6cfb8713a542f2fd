#include "engine/analyse/study/study_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/within_subjects.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::study {
namespace {

constexpr const char* quantities[]{"difference", "low",         "high", "p_pair",
                                   "holm",       "signed_rank", "d",    "needed"};

/// Returns the values of one pair, in the order of the quantities.
std::vector<double> values_of(const statistics::PairComparison& one, const statistics::PowerRow& power) {
  return {one.test.mean,
          one.test.interval.low,
          one.test.interval.high,
          one.test.p,
          one.holm,
          one.ranks.p,
          one.effect.d_z,
          power.needed_simulated ? static_cast<double>(*power.needed_simulated) : statistics::no_number};
}

/// Returns "p.guiding_path" for "guiding path".
std::string column_of(const std::string& start, std::string factor) {
  std::replace(factor.begin(), factor.end(), ' ', '_');
  return start + factor;
}

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Returns the mean deviations of the conditions, named "deviation.HV".
std::vector<NamedValue> mean_deviations(const Experiment& experiment, const StudyRequest& request) {
  std::vector<NamedValue> values;
  for (const std::string& condition : request.condition_names()) {
    double sum = 0.0, count = 0.0;
    for (const PathError& row : experiment.errors.rows)
      if (row.condition == condition) sum += row.deviation, ++count;
    values.push_back({"deviation." + condition, count > 0.0 ? sum / count : not_known});
  }
  return values;
}

/// Returns the column of a carried parameter. A swept one already has a column for its value in the first
/// trial.
std::string column_of(const std::string& parameter, const diagram::Diagram& diagram) {
  const bool swept =
      diagram.sweep && std::ranges::find(diagram.sweep->axes, parameter, &diagram::Sweep::Axis::parameter) !=
                           diagram.sweep->axes.end();
  return swept ? "carried." + parameter : parameter;
}

/// Adds one column per element of a parameter: "memory", or "memory.1", "memory.2".
void add_carried_columns(const std::string& name, const diagram::Diagram& diagram,
                         std::vector<table::Column>& columns) {
  const auto& parameter = *std::ranges::find(diagram.parameters, name, &diagram::DiagramParameter::name);
  const std::string unit = parameter.dimension ? unit::si_name(*parameter.dimension) : "";
  const auto* list = std::get_if<Eigen::VectorXd>(&parameter.value.content);
  const std::string column = column_of(name, diagram);
  if (!list) columns.push_back({column, unit, {}});
  for (Eigen::Index i = 1; list && i <= list->size(); ++i)
    columns.push_back({fmt::format("{}.{}", column, i), unit, {}});
}

double nan() {
  return std::numeric_limits<double>::quiet_NaN();
}

void fill(table::Column column, std::size_t rows, double value, record::Recording& recording,
          std::size_t at) {
  column.values.assign(rows, value);
  recording.table.columns.insert(recording.table.columns.begin() + static_cast<std::ptrdiff_t>(at),
                                 std::move(column));
}

/// Returns the recording of a recorded trial, with those columns that a run would record.
record::Recording recording_of(const Trial& trial, const StudyRequest& request, const plan::Plan& plan,
                               std::size_t r) {
  record::Recording recording;
  for (const record::RecordedColumn& recorded : record::recorded_columns(plan, plan.diagram.records[r])) {
    table::Column column{recorded.name, recorded.dimension ? unit::si_name(*recorded.dimension) : "",
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

/// Renumbers words in the order of the request instead of the order of the rows.
void number_words(const StudyRequest& request, const Experiment& experiment, record::Recording& recording) {
  const std::vector<std::string> subjects = request.subject_names(), conditions = request.condition_names();
  recording.categories = {{"subject", subjects}, {"condition", conditions}};
  for (table::Column& column : recording.table.columns) {
    if (column.name != "subject" && column.name != "condition") continue;
    const bool person = column.name == "subject";
    for (std::size_t row = 0; row < column.values.size(); ++row)
      column.values[row] =
          static_cast<double>(person ? place_in(subjects, experiment.errors.rows[row].subject)
                                     : place_in(conditions, experiment.errors.rows[row].condition));
  }
}

record::Recording pooled(const Experiment& experiment, const StudyRequest& request, const plan::Plan& plan,
                         std::size_t r) {
  const std::vector<std::string> subjects = request.subject_names(), conditions = request.condition_names();
  record::Recording all;
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    const Trial& trial = experiment.trials[i];
    record::Recording one = experiment.runs.empty() ? recording_of(trial, request, plan, r)
                                                    : experiment.runs[i].result.recordings[r];
    const std::size_t rows = one.table.rows();
    fill({"subject", "", {}}, rows, static_cast<double>(place_in(subjects, trial.subject)), one, 1);
    fill({"condition", "", {}}, rows, static_cast<double>(place_in(conditions, trial.condition)), one, 2);
    run::append_runs(all, std::move(one));
  }
  all.categories = {{"subject", subjects}, {"condition", conditions}};
  return all;
}

/// Returns the errors with the words of the request. Each trial is a run of one row, so that means are not
/// taken over time.
record::Recording errors_of(const Experiment& experiment, const StudyRequest& request,
                            const diagram::Diagram& diagram) {
  record::Recording recording = error_recording(experiment.errors);
  number_words(request, experiment, recording);
  std::ranges::move(sequence_columns(experiment, request, diagram),
                    std::back_inserter(recording.table.columns));
  recording.starts.clear();
  for (std::size_t row = 0; row < experiment.errors.rows.size(); ++row) recording.starts.push_back(row);
  return recording;
}

/// Returns "published.HV" for each condition with a published mean.
std::vector<NamedValue> published_means(const StudyRequest& request) {
  std::vector<NamedValue> means = request.published.means.values;
  for (NamedValue& mean : means) mean.name = "published." + mean.name;
  return means;
}

/// Returns a recording with one row per experiment.
record::Recording outcome_recording(const Experiment& experiment, const StudyRequest& request) {
  const std::vector<ExperimentOutcome> rows = outcomes(experiment, request);
  record::Recording recording;
  recording.starts.clear();
  table::Column number{"experiment", "", {}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    recording.starts.push_back(row);
    number.values.push_back(static_cast<double>(row + 1));
  }
  auto& columns = recording.table.columns;
  columns.push_back({"time", "s", std::vector<double>(rows.size(), 0.0)});
  columns.push_back(std::move(number));
  for (const OutcomeColumn& column : outcome_columns(request)) {
    columns.push_back({column.name, column.unit, {}});
    for (const ExperimentOutcome& row : rows)
      columns.back().values.push_back(value_of(row.values, column.name));
  }
  for (const NamedValue& mean : published_means(request))
    columns.push_back({mean.name, "", std::vector<double>(rows.size(), mean.value)});
  return recording;
}

/// Adds the columns of a study to the names of figures and claims.
class StudyNames {
 public:
  StudyNames(const StudyRequest& request, query::SymbolTable& names) : request_(request), names_(names) {
    for (const query::RecordedName& name : names.columns)
      if (name.recording) records_ = std::max(records_, *name.recording + 1);
  }

  /// Adds the columns of all recordings.
  void add_trials() {
    add("subject", "1", {});
    names_.columns.back().words = request_.subject_names();
    add("condition", "1", {});
    names_.columns.back().words = request_.condition_names();
  }

  /// Adds the columns of the recording of errors, one row per trial.
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

  /// Adds to it the columns on the sequence of a person's trials.
  void add_sequence(const diagram::Diagram& diagram) {
    for (const table::Column& column : sequence_columns({}, request_, diagram))
      add(column.name, column.unit.empty() ? "1" : column.unit, records_);
  }

  /// Adds the columns of the recording of results, one row per experiment.
  void add_outcome() {
    const std::size_t outcome = records_ + 1;
    add("experiment", "1", outcome);
    for (const OutcomeColumn& column : outcome_columns(request_))
      add(column.name, column.unit.empty() ? "1" : column.unit, outcome);
    for (const NamedValue& mean : published_means(request_)) add(mean.name, "1", outcome);
  }

 private:
  void add(const std::string& name, const std::string& unit, std::optional<std::size_t> recording) {
    if (names_.find(name))
      throw yaml::Error(
          yaml::Fault{request_.place,
                      "study",
                      fmt::format("makes a column '{}', and so does the file; record that signal under "
                                  "another name: {{NAME: {}}}",
                                  name, name),
                      {}});
    names_.columns.push_back({name, unit::parse_unit(unit)->dimension, recording});
  }

  const StudyRequest& request_;
  query::SymbolTable& names_;
  const bool circle_ = request_.circle.has_value();
  std::size_t records_ = 0;  ///< Number of recordings of the diagram itself.
};

}  // namespace

std::vector<std::string> comparison_columns(const StudyRequest& request) {
  std::vector<std::string> pairs, columns;
  const auto names = request.condition_names();
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t k = i + 1; k < names.size(); ++k) pairs.push_back(names[i] + "_" + names[k]);
  for (const std::string& pair : pairs)
    for (const char* quantity : quantities)
      if (std::count(pairs.begin(), pairs.end(), pair) == 1)
        columns.push_back(fmt::format("{}.{}", quantity, pair));
  return columns;
}

std::vector<NamedValue> comparison_values(const Experiment& experiment, const StudyRequest& request) {
  std::vector<NamedValue> found, values;
  if (experiment.analysis && experiment.analysis->within) {
    const statistics::WithinSubjects& within = *experiment.analysis->within;
    statistics::PowerSimulation simulation;
    simulation.seed = experiment.seed;
    const auto power = statistics::power_rows(within, simulation);
    for (std::size_t i = 0; i < within.comparisons.size(); ++i) {
      const statistics::PairComparison& one = within.comparisons[i];
      const auto numbers = values_of(one, power[i]);
      for (std::size_t k = 0; k < numbers.size(); ++k)
        found.push_back({fmt::format("{}.{}_{}", quantities[k], one.first, one.second), numbers[k]});
    }
  }
  for (const std::string& name : comparison_columns(request)) values.push_back({name, value_of(found, name)});
  return values;
}

std::vector<OutcomeColumn> outcome_columns(const StudyRequest& request) {
  std::vector<OutcomeColumn> columns;
  const std::string deviation = request.circle ? "m" : "rad";
  for (const std::string& condition : request.condition_names()) columns.push_back({"mean." + condition});
  for (const char* start : {"p.", "p_subject.", "effect."})
    for (const std::string& factor : factors_of(request.factored()))
      columns.push_back({column_of(start, factor)});
  for (const std::string& condition : request.condition_names())
    columns.push_back({"deviation." + condition, deviation});
  for (const std::string& column : comparison_columns(request)) columns.push_back({column});
  return columns;
}

std::vector<NamedValue> outcome(const Experiment& experiment, const StudyRequest& request) {
  std::vector<NamedValue> values;
  for (const OutcomeColumn& column : outcome_columns(request)) values.push_back({column.name, not_known});
  const auto set = [&](const std::string& name, double value) {
    for (NamedValue& one : values)
      if (one.name == name) one.value = value;
  };
  for (const NamedValue& mean : mean_deviations(experiment, request)) set(mean.name, mean.value);
  if (!experiment.analysis) return values;
  const TaskAnalysis& analysis = *experiment.analysis;
  for (const NamedValue& mean : analysis.means) set("mean." + mean.name, mean.value);
  for (const NamedValue& effect : analysis.effects) set(column_of("effect.", effect.name), effect.value);
  for (const auto& [start, anova] :
       {std::pair{"p.", &analysis.additive}, std::pair{"p_subject.", &analysis.with_subject}})
    for (const statistics::AnovaRow& row : anova->terms) set(column_of(start, row.name), row.p);
  for (const NamedValue& value : comparison_values(experiment, request)) set(value.name, value.value);
  return values;
}

std::vector<ExperimentOutcome> outcomes(const Experiment& experiment, const StudyRequest& request) {
  std::vector<ExperimentOutcome> all{{experiment.seed, outcome(experiment, request)}};
  all.insert(all.end(), experiment.others.begin(), experiment.others.end());
  return all;
}

std::vector<table::Column> sequence_columns(const Experiment& experiment, const StudyRequest& request,
                                            const diagram::Diagram& diagram) {
  std::vector<table::Column> columns{{"order", "", {}}};
  for (const CarriedValue& carried : request.carry) add_carried_columns(carried.parameter, diagram, columns);
  for (const TrialRun& run : experiment.runs) {
    std::vector<double> numbers{static_cast<double>(run.order)};
    for (const std::vector<double>& values : run.begun)
      numbers.insert(numbers.end(), values.begin(), values.end());
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].values.push_back(numbers[i]);
  }
  for (table::Column& column : columns)
    column.values.resize(experiment.trials.size(), std::numeric_limits<double>::quiet_NaN());
  return columns;
}

void add_study_names(const StudyRequest& request, const diagram::Diagram& diagram,
                     query::SymbolTable& names) {
  StudyNames study(request, names);
  study.add_trials();
  study.add_errors();
  study.add_sequence(diagram);
  study.add_outcome();
}

std::vector<record::Recording> study_recordings(const Experiments& experiments, const StudyRequest& request,
                                                const run::Job& job) {
  const std::size_t records = job.plan.diagram.records.size();
  const run::SweptColumns swept(job);
  std::vector<record::Recording> recordings(records + 2);
  for (std::size_t study = 0; study < experiments.size(); ++study) {
    const Experiment& experiment = experiments[study];
    const auto add = [&](std::size_t r, record::Recording one) {
      swept.add(one, study);
      run::append_runs(recordings[r], std::move(one));
    };
    for (std::size_t r = 0; r < records; ++r) add(r, pooled(experiment, request, job.plan, r));
    add(records, errors_of(experiment, request, job.plan.diagram));
    add(records + 1, outcome_recording(experiment, request));
  }
  return recordings;
}

}  // namespace stepwire::study

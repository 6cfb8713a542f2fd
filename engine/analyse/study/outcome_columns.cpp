#include "engine/analyse/study/outcome_columns.hpp"

#include <algorithm>
#include <limits>

#include "engine/analyse/study/comparison_columns.hpp"

namespace stepwire::study {

namespace {

const std::vector<std::pair<const char*, bool FeedbackCondition::*>> factors{
    {"haptic", &FeedbackCondition::haptic},
    {"visual", &FeedbackCondition::visual},
    {"guiding path", &FeedbackCondition::guiding_path}};

/// Returns "p.guiding_path" for "guiding path".
std::string column_of(const std::string& start, std::string factor) {
  std::replace(factor.begin(), factor.end(), ' ', '_');
  return start + factor;
}

/// Returns the feedbacks in which the conditions differ.
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

}  // namespace

std::vector<OutcomeColumn> outcome_columns(const StudyRequest& request) {
  std::vector<OutcomeColumn> columns;
  const std::string deviation = request.task == "1" ? "m" : "rad";
  for (const std::string& condition : request.condition_names()) columns.push_back({"mean." + condition});
  for (const char* start : {"p.", "p_subject.", "effect."})
    for (const std::string& factor : factors_of(request)) columns.push_back({column_of(start, factor)});
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

}  // namespace stepwire::study

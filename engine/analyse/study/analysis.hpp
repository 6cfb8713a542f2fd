#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/statistics/within_subjects.hpp"
#include "engine/analyse/study/path_errors.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/text/text_table.hpp"

namespace stepwire::study {

/// A named number, such as the mean error of a condition.
struct NamedValue {
  std::string name;
  double value = 0.0;
};

/// Returns the value of a name; nan if there is none.
double value_of(const std::vector<NamedValue>& values, const std::string& name);

/// Analysis of the errors of one task.
struct TaskAnalysis {
  std::vector<NamedValue> means;    ///< Normalised error over all subjects, by condition.
  std::vector<NamedValue> effects;  ///< Effect of each factor on these means.
  statistics::Anova additive;  ///< Factors of the conditions only: the form of the thesis' tables 4 and 6.
  statistics::Anova with_subject;  ///< The same with the subject as a factor.
  /// Repeated measures over the factors and their interactions if all their combinations are conditions,
  /// else over the conditions.
  std::optional<statistics::Anova> repeated;
  std::string not_repeated;                          ///< Reason why there is none.
  std::optional<statistics::WithinSubjects> within;  ///< Pairs of conditions, for subjects who have met all.
  std::string not_within;                            ///< Reason why there is none.
};

/// Returns the main effect of each factor on the mean errors of conditions, by least squares; negative if
/// it lowers them. Nan if the conditions do not separate the factors.
std::vector<NamedValue> factor_effects(const std::vector<NamedValue>& means,
                                       const std::vector<Condition>& conditions);

/// Analyses the errors of a task. Throws StatisticsError for the faults of `observations` and `anova`.
TaskAnalysis analyse(const PathErrors& errors, const std::vector<Condition>& conditions);

/// Returns an analysis of variance as a table: its lines, then notes on the method and warnings.
text::TextTable anova_table(const statistics::Anova& anova, const std::string& title);

/// Returns the test of sphericity and both corrections as JSON.
json::Json sphericity_json(const statistics::Sphericity& of);

/// Returns it as JSON; missing values are null.
json::Json anova_json(const statistics::Anova& anova);

/// Returns quartiles, mean and number of the normalised errors by condition.
text::TextTable error_summary(const PathErrors& errors);

/// Formats a probability with three digits: "2.02e-05", "0.216".
std::string printed_probability(double p);

}  // namespace stepwire::study

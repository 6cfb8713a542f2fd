#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/statistics/within_subjects.hpp"
#include "engine/analyse/study/path_errors.hpp"
#include "engine/base/json/json.hpp"
#include "engine/base/text/text_table.hpp"

namespace stepwire::study {

/// A number with its name, such as the mean error of a condition.
struct NamedValue {
  std::string name;
  double value = 0.0;
};

/// The value of that name; nan where there is none.
double value_of(const std::vector<NamedValue>& values, const std::string& name);

/// What the errors of one task say.
struct TaskAnalysis {
  std::vector<NamedValue> means;    ///< normalised error over all subjects, by condition
  std::vector<NamedValue> effects;  ///< of each feedback on these means
  statistics::Anova additive;       ///< the feedbacks alone: the form of the thesis' tables 4 and 6
  statistics::Anova with_subject;   ///< the same with the subject as a factor
  /// Within subjects: the feedbacks and their interactions where all combinations were drawn (task 1), else
  /// the conditions (task 2).
  std::optional<statistics::Anova> repeated;
  std::string not_repeated;  ///< why there is none
  std::optional<statistics::WithinSubjects>
      within;              ///< pairs of conditions, by the subjects who have met all of them
  std::string not_within;  ///< why there is none
};

/// What each feedback adds to the mean errors of conditions, beside the other feedbacks (least squares of
/// main effects): below 0 where it lowers them. Nan where the conditions do not tell the feedbacks apart.
std::vector<NamedValue> feedback_effects(const std::vector<NamedValue>& means,
                                         const std::vector<FeedbackCondition>& conditions);

/// Throws StatisticsError for what `observations` and `anova` refuse.
TaskAnalysis analyse(const PathErrors& errors,
                     const std::vector<FeedbackCondition>& conditions = thesis_conditions());

/// An analysis of variance for readers: its lines, then how it was made and what to mind.
text::TextTable anova_table(const statistics::Anova& anova, const std::string& title);

/// The same for programs; what does not exist is null.
json::Json anova_json(const statistics::Anova& anova);

/// Quartiles, mean and number of normalised errors by condition.
text::TextTable error_summary(const PathErrors& errors);

/// A probability with three digits as tables print it: "2.02e-05", "0.216".
std::string printed_probability(double p);

}  // namespace stepwire::study

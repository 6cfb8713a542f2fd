#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/published.hpp"

namespace stepwire::study {

/// P below which an effect is significant.
inline constexpr double significant = 0.05;

/// A published value and ours; missing ones are nan.
struct ComparedValue {
  std::string name;
  double published = 0.0, ours = 0.0;
};

/// Agreement with one statement of the thesis: "order NO > H > V > HV", false, "ours: H > NO > V > HV".
struct Agreement {
  std::string that;
  bool agrees = false;
  std::string ours;
};

/// Values of the thesis and ours.
struct SideBySide {
  std::string title;
  std::string quantity;  ///< Name of the quantity: "mean normalised error", "P".
  std::vector<ComparedValue> values;
  std::vector<Agreement> agreements;
  std::vector<ComparedValue> effects{};  ///< For P: effect of each factor on the error.
};

/// Compares the orders of the conditions' errors that the text states. Each list is reduced to the conditions
/// that we have.
std::vector<Agreement> judge_orders(const std::vector<std::vector<std::string>>& order,
                                    const std::vector<NamedValue>& ours);

/// Compares the errors of conditions: the orders of the text, and the ratios to the largest published error,
/// which agree within a factor of two.
SideBySide compare_errors(const PublishedValues& published, const std::vector<NamedValue>& ours,
                          const std::vector<std::vector<std::string>>& order);

/// Compares P of factors. A factor agrees if it is significant at 0.05 in both or in neither, and if
/// significant effects have the same sign.
SideBySide compare_significance(const PublishedStudy& published, const TaskAnalysis& ours,
                                const std::vector<Condition>& conditions);

/// Returns all comparisons of a task: means, then significance.
std::vector<SideBySide> compare(const PublishedStudy& published, const TaskAnalysis& ours,
                                const std::vector<Condition>& conditions);

/// Returns a comparison as a table: columns for the thesis, ours and the ratio; agreements below.
text::TextTable side_by_side_table(const SideBySide& both);

/// Returns a comparison as JSON.
json::Json side_by_side_json(const SideBySide& both);

}  // namespace stepwire::study

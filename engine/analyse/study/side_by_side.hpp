#pragma once

#include <string>
#include <vector>

#include "engine/analyse/study/published.hpp"

namespace stepwire::study {

/// P below which an effect is called significant.
inline constexpr double significant = 0.05;

/// A published value and ours; nan where one of them does not exist.
struct ComparedValue {
  std::string name;
  double published = 0.0, ours = 0.0;
};

/// Whether ours agrees with one statement of the thesis, in words: "order NO > H > V > HV", false, "ours: H >
/// NO > V > HV".
struct Agreement {
  std::string that;
  bool agrees = false;
  std::string ours;
};

/// The thesis' values beside ours.
struct SideBySide {
  std::string title;
  std::string quantity;  ///< "mean normalised error", "P"
  std::vector<ComparedValue> values;
  std::vector<Agreement> agreements;
  std::vector<ComparedValue> effects{};  ///< of P: what each factor adds to the error
};

/// The orders that the text states of the conditions' errors: each list, as far as we have its conditions.
std::vector<Agreement> judge_orders(const std::vector<std::vector<std::string>>& order,
                                    const std::vector<NamedValue>& ours);

/// Errors of conditions: the orders that the text states of them, and whether every ratio to the largest
/// published one agrees within a factor of two.
SideBySide compare_errors(const PublishedValues& published, const std::vector<NamedValue>& ours,
                          const std::vector<std::vector<std::string>>& order);

/// P of factors: each is significant in both or in neither, at 0.05, and what is significant lowers the error
/// in both or raises it in both.
SideBySide compare_significance(const PublishedStudy& published, const TaskAnalysis& ours);

/// All that can be compared of a task: means, then significance.
std::vector<SideBySide> compare(const PublishedStudy& published, const TaskAnalysis& ours);

/// For readers: a column for the thesis, one for ours, one for the ratio; the agreements below.
text::TextTable side_by_side_table(const SideBySide& both);

/// For programs.
json::Json side_by_side_json(const SideBySide& both);

}  // namespace stepwire::study

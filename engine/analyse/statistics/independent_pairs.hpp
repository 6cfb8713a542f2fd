#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/observations.hpp"
#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Two groups of independent values, compared by the t test of Welch (1947), whose variances may differ.
struct IndependentPair {
  std::string first, second;      ///< names of the groups
  double difference = 0.0;        ///< mean of the first minus that of the second
  ConfidenceInterval interval{};  ///< of the difference, 95 %
  double t = 0.0, freedom = 0.0;  ///< degrees of freedom after Welch and Satterthwaite
  double p = 0.0, holm = 0.0;     ///< as it is, and corrected for all pairs
};

/// Compares all pairs of groups; a group is a combination of levels of some factors that has a value. Numbers
/// of a pair are nan where a group has one value alone, or both have no spread.
std::vector<IndependentPair> independent_pairs(const Observations& observations,
                                               const std::vector<std::string>& factors);

}  // namespace stepwire::statistics

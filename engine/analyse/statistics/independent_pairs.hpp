#pragma once

#include <string>
#include <vector>

#include "engine/analyse/statistics/observations.hpp"
#include "engine/analyse/statistics/paired_test.hpp"

namespace stepwire::statistics {

/// Comparison of two independent groups by Welch's t test (1947), which allows unequal variances.
struct IndependentPair {
  std::string first, second;      ///< Names of the groups.
  double difference = 0.0;        ///< Mean of the first minus mean of the second.
  ConfidenceInterval interval{};  ///< 95 % interval of the difference.
  double t = 0.0, freedom = 0.0;  ///< Degrees of freedom after Welch and Satterthwaite.
  double p = 0.0, holm = 0.0;     ///< P uncorrected, and corrected for all pairs.
};

/// Compares all pairs of groups. A group is a combination of levels of the factors with at least one value.
/// The numbers of a pair are nan if a group has only one value, or if neither has any spread.
std::vector<IndependentPair> independent_pairs(const Observations& observations,
                                               const std::vector<std::string>& factors);

}  // namespace stepwire::statistics

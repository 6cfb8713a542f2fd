#pragma once

#include <cstddef>
#include <vector>

namespace stepwire::statistics {

/// Wilcoxon's signed-rank test of differences between two conditions. Differences of zero are left out, equal
/// ones share the mean of their ranks.
struct SignedRank {
  double sum = 0.0;       ///< V: of the ranks of differences above 0
  double p = 1.0;         ///< two-sided; nan where no difference is left
  bool exact = true;      ///< over all signs of these ranks, ties among them; else by the normal distribution
  std::size_t count = 0;  ///< differences other than zero
};

/// Exact up to `largest_exact` differences, beyond them with the correction for continuity.
SignedRank signed_rank_test(const std::vector<double>& differences, std::size_t largest_exact = 50);

}  // namespace stepwire::statistics

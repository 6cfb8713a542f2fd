#pragma once

#include <cstddef>
#include <vector>

namespace stepwire::statistics {

/// Wilcoxon's signed-rank test of differences between two conditions. Zero differences are left out; equal
/// ones share the mean of their ranks.
struct SignedRank {
  double sum = 0.0;       ///< V, the sum of the ranks of positive differences.
  double p = 1.0;         ///< Two-sided P; nan if all differences are zero.
  bool exact = true;      ///< True: P is exact, over all signs of these ranks including ties; false: by the
                          ///< normal distribution.
  std::size_t count = 0;  ///< Number of differences other than zero.
};

/// Computes the test: exact up to `largest_exact` differences, else normal with continuity correction.
SignedRank signed_rank_test(const std::vector<double>& differences, std::size_t largest_exact = 50);

}  // namespace stepwire::statistics

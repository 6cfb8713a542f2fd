#pragma once

#include <vector>

namespace stepwire::statistics {

/// Returns the ranks 1..n; equal values share the mean of their ranks.
std::vector<double> ranks(const std::vector<double>& values);

/// Returns Spearman's rank correlation, the correlation of the ranks. Nan for fewer than two values, for a
/// constant side, and for a nan among the values.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace stepwire::statistics

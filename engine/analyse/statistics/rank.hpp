#pragma once

#include <vector>

namespace stepwire::statistics {

/// Ranks 1..n; equal values share the mean of their ranks.
std::vector<double> ranks(const std::vector<double>& values);

/// Spearman's rank correlation: the correlation of the ranks. nan for fewer than two values, where one side
/// is constant, and where a value is nan.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace stepwire::statistics

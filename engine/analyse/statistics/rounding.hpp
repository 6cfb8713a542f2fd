#pragma once

#include <limits>
#include <vector>

namespace stepwire::statistics {

/// What rounding leaves of numbers that do not vary, as a share of their size: some hundred times the
/// distance of neighbouring doubles. Variation that thirteen decimal digits still show is beyond it.
inline constexpr double rounding_share = 100.0 * std::numeric_limits<double>::epsilon();

/// Is a variation no more than what rounding leaves of scores of this size? Both are of one kind: the largest
/// of them, or the root of a sum of squares.
inline bool is_rounding(double variation, double size) {
  return variation <= rounding_share * size;
}

/// The largest of the absolute values; 0 of none.
double largest_of(const std::vector<double>& values);

/// Differences of scores of this size. What is rounding alone becomes 0; differences that only rounding tells
/// apart become equal, so that no test takes rounding for an effect.
std::vector<double> without_rounding(std::vector<double> differences, double size);

}  // namespace stepwire::statistics

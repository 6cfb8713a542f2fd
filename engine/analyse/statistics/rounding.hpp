#pragma once

#include <limits>
#include <vector>

namespace stepwire::statistics {

/// Relative rounding error of numbers that should be equal: about a hundred times the distance of
/// neighbouring doubles. Variation visible in thirteen decimal digits is larger.
inline constexpr double rounding_share = 100.0 * std::numeric_limits<double>::epsilon();

/// True if a variation is within the rounding error of scores of this size. Both are maxima, or both are
/// roots of sums of squares.
inline bool is_rounding(double variation, double size) {
  return variation <= rounding_share * size;
}

/// Returns the largest absolute value; 0 for an empty list.
double largest_of(const std::vector<double>& values);

/// Removes rounding error from differences of scores of this size. Differences within it become 0; if all
/// agree within it, they become equal. Otherwise a test could report rounding as an effect.
std::vector<double> without_rounding(std::vector<double> differences, double size);

}  // namespace stepwire::statistics

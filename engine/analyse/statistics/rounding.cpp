#include "engine/analyse/statistics/rounding.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::statistics {

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

std::vector<double> without_rounding(std::vector<double> differences, double size) {
  if (differences.empty()) return differences;
  for (double& difference : differences)
    if (is_rounding(std::abs(difference), size)) difference = 0.0;
  const auto [least, most] = std::minmax_element(differences.begin(), differences.end());
  if (is_rounding(*most - *least, size)) std::fill(differences.begin(), differences.end(), *least);
  return differences;
}

}  // namespace stepwire::statistics

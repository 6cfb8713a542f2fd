#include "engine/analyse/statistics/equal_variances.hpp"

#include <cmath>

#include "engine/analyse/statistics/moments.hpp"
#include "engine/analyse/statistics/quartiles.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/tail.hpp"

namespace stepwire::statistics {
namespace {

double squares_about(const std::vector<double>& values, double middle) {
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return sum;
}

std::vector<double> distances(const std::vector<double>& group, Middle middle) {
  const double first = group.front();  // differences from it keep the digits that a large mean would cost
  std::vector<double> result;
  for (const double value : group) result.push_back(value - first);
  const double from = middle == Middle::mean ? moments_of(result).mean : box_summary(result).median;
  for (double& value : result) value = std::abs(value - from);
  return result;
}

/// Returns the root of the sum of all squares.
double size_of(const std::vector<std::vector<double>>& groups) {
  double squares = 0.0;
  for (const auto& group : groups) squares += squares_about(group, 0.0);
  return std::sqrt(squares);
}

}  // namespace

std::optional<VarianceTest> variance_test(const std::vector<std::vector<double>>& groups, Middle middle) {
  std::vector<double> all;
  std::vector<std::vector<double>> kept;
  for (const auto& group : groups) {
    if (group.size() < 2) continue;
    kept.push_back(distances(group, middle));
    all.insert(all.end(), kept.back().begin(), kept.back().end());
  }
  if (kept.size() < 2) return std::nullopt;
  double between = 0.0, within = 0.0;
  const double centre = moments_of(all).mean;
  for (const auto& group : kept) {
    between += static_cast<double>(group.size()) * std::pow(moments_of(group).mean - centre, 2);
    within += moments_of(group).squares;
  }
  if (is_rounding(std::sqrt(within), size_of(groups))) return std::nullopt;
  VarianceTest test;
  test.above = static_cast<double>(kept.size() - 1);
  test.below = static_cast<double>(all.size() - kept.size());
  test.f = (between / test.above) / (within / test.below);
  test.p = fisher_tail(test.f, test.above, test.below);
  return test;
}

}  // namespace stepwire::statistics

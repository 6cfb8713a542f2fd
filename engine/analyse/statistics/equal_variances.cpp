#include "engine/analyse/statistics/equal_variances.hpp"

#include <cmath>
#include <numeric>

#include "engine/analyse/statistics/quartiles.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/tail.hpp"

namespace stepwire::statistics {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double squares_about(const std::vector<double>& values, double middle) {
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return sum;
}

std::vector<double> distances(const std::vector<double>& group, Middle middle) {
  const double from = middle == Middle::mean ? mean(group) : box_summary(group).median;
  std::vector<double> result;
  for (const double value : group) result.push_back(std::abs(value - from));
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
  const double centre = mean(all);
  for (const auto& group : kept) {
    between += static_cast<double>(group.size()) * std::pow(mean(group) - centre, 2);
    within += squares_about(group, mean(group));
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

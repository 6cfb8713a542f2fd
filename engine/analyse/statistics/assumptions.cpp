#include "engine/analyse/statistics/assumptions.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/distributions.hpp"
#include "engine/analyse/statistics/rounding.hpp"

namespace stepwire::statistics {
namespace {

constexpr std::size_t fewest_values = 3, most_values = 5000;

/// Evaluates a polynomial; coefficients are in ascending order.
double polynomial_at(const std::vector<double>& coefficients, double x) {
  double sum = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

/// Returns the expected upper half of n sorted normal values, the largest first (Blom's approximation).
std::vector<double> upper_scores(std::size_t n) {
  const boost::math::normal standard;
  std::vector<double> scores;
  for (std::size_t i = 1; i <= n / 2; ++i) {
    const double share = (static_cast<double>(i) - 0.375) / (static_cast<double>(n) + 0.25);
    scores.push_back(-boost::math::quantile(standard, share));
  }
  return scores;
}

/// Returns the weights of the upper half of the sorted values, the largest first; the lower half has their
/// negatives. The outermost weight (two for more than five values) is from a fit, the others are from the
/// scores.
std::vector<double> weights(std::size_t n) {
  if (n == fewest_values) return {std::sqrt(0.5)};
  std::vector<double> scores = upper_scores(n);
  const double sum = 2.0 * std::inner_product(scores.begin(), scores.end(), scores.begin(), 0.0);
  const double x = 1.0 / std::sqrt(static_cast<double>(n));
  const std::vector<std::vector<double>> fits{{0.0, 0.221157, -0.147981, -2.07119, 4.434685, -2.706056},
                                              {0.0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633}};
  std::vector<double> outer;
  double squares = sum, left = 1.0;
  for (std::size_t i = 0; i < (n > 5 ? 2u : 1u); ++i) {
    outer.push_back(polynomial_at(fits[i], x) + scores[i] / std::sqrt(sum));
    squares -= 2.0 * scores[i] * scores[i];
    left -= 2.0 * outer[i] * outer[i];
  }
  for (double& score : scores) score /= std::sqrt(squares / left);
  std::copy(outer.begin(), outer.end(), scores.begin());
  return scores;
}

/// Returns 1 - W of sorted values.
double lack(const std::vector<double>& sorted) {
  const std::size_t n = sorted.size();
  const auto a = weights(n);
  const double xx = moments_of(sorted).squares;
  double both = 0.0, aa = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += a[i] * (sorted[n - 1 - i] - sorted[i]);
    aa += 2.0 * a[i] * a[i];
  }
  const double most_possible = std::sqrt(aa * xx);
  return (most_possible - both) * (most_possible + both) / (aa * xx);
}

/// Returns P of 1 - W. For three values the distribution is known; else a power or the logarithm of 1 - W is
/// nearly normal.
double probability(double lack, std::size_t n) {
  constexpr double smallest = 1e-99;
  if (n == fewest_values)
    return std::max(0.0,
                    6.0 / std::numbers::pi * (std::asin(std::sqrt(1.0 - lack)) - std::numbers::pi / 3.0));
  const auto count = static_cast<double>(n);
  const double logarithm = std::log(count);
  double y = std::log(lack), mean = 0.0, deviation = 0.0;
  if (n <= 11) {
    const double gamma = polynomial_at({-2.273, 0.459}, count);
    if (y >= gamma) return smallest;
    y = -std::log(gamma - y);
    mean = polynomial_at({0.544, -0.39978, 0.025054, -6.714e-4}, count);
    deviation = std::exp(polynomial_at({1.3822, -0.77857, 0.062767, -0.0020322}, count));
  } else {
    mean = polynomial_at({-1.5861, -0.31082, -0.083751, 0.0038915}, logarithm);
    deviation = std::exp(polynomial_at({-0.4803, -0.082676, 0.0030302}, logarithm));
  }
  return 0.5 * std::erfc((y - mean) / deviation / std::numbers::sqrt2);
}

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

std::optional<Normality> shapiro_wilk(std::vector<double> values) {
  if (values.size() < fewest_values || values.size() > most_values) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double range = values.back() - values.front();
  if (is_rounding(range, largest_of(values))) return std::nullopt;
  for (double& value : values) value /= range;  // avoids underflow and overflow of squares
  const double beyond = std::max(0.0, lack(values));
  return Normality{1.0 - beyond, probability(beyond, values.size())};
}

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

#include "engine/analyse/statistics/signed_rank.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/statistics/rank.hpp"

namespace stepwire::statistics {
namespace {

/// Returns the share of all sign combinations whose positive ranks sum to `sum` or less. Tied ranks are
/// multiples of 1/2, so twice a rank is an integer.
double lower_tail(const std::vector<double>& ranks, double sum) {
  std::vector<double> ways{1.0};  // share of the signs so far by twice the rank sum
  for (const double rank : ranks) {
    const auto step = static_cast<std::size_t>(std::lround(2.0 * rank));
    ways.resize(ways.size() + step, 0.0);
    for (std::size_t i = ways.size(); i-- > 0;)
      ways[i] = 0.5 * (ways[i] + (i >= step ? ways[i - step] : 0.0));
  }
  double tail = 0.0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(std::lround(2.0 * sum)); ++i) tail += ways[i];
  return tail;
}

double exact_probability(const std::vector<double>& ranks, double sum) {
  double total = 0.0;
  for (const double rank : ranks) total += rank;
  return std::min(1.0, 2.0 * lower_tail(ranks, std::min(sum, total - sum)));  // the distribution is symmetric
}

double normal_probability(const std::vector<double>& ranks, double sum) {
  double mean = 0.0, variance = 0.0;
  for (const double rank : ranks) mean += 0.5 * rank, variance += 0.25 * rank * rank;
  const double beyond = std::max(0.0, std::abs(sum - mean) - 0.5);
  return std::min(1.0, std::erfc(beyond / std::sqrt(2.0 * variance)));
}

}  // namespace

SignedRank signed_rank_test(const std::vector<double>& differences, std::size_t largest_exact) {
  std::vector<double> kept, sizes;
  for (const double difference : differences)
    if (difference != 0.0) kept.push_back(difference), sizes.push_back(std::abs(difference));
  SignedRank test;
  test.count = kept.size();
  if (kept.empty()) {
    test.p = std::numeric_limits<double>::quiet_NaN();
    return test;
  }
  const auto ranked = ranks(sizes);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i] > 0.0) test.sum += ranked[i];
  test.exact = kept.size() <= largest_exact;
  test.p = test.exact ? exact_probability(ranked, test.sum) : normal_probability(ranked, test.sum);
  return test;
}

}  // namespace stepwire::statistics

#include "engine/analyse/statistics/proportion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/distributions.hpp"

namespace stepwire::statistics {

namespace {

/// Returns the probability that fewer than `rank` of the values are below the quantile of a share. It is that
/// of a binomial distribution, computed by the incomplete beta function.
double probability_of_fewer(std::size_t rank, std::size_t count, double share) {
  if (rank == 0) return 0.0;
  if (rank > count) return 1.0;
  return beta_tail(share, static_cast<double>(rank), static_cast<double>(count - rank + 1));
}

/// Returns the largest rank whose probability_of_fewer() is at most `probability`, by bisection.
std::size_t largest_rank(std::size_t count, double share, double probability) {
  std::size_t low = 0, high = count + 1;  // the probability grows with the rank
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (probability_of_fewer(middle, count, share) <= probability ? low : high) = middle;
  }
  return low;
}

}  // namespace

ConfidenceInterval proportion_interval(std::size_t successes, std::size_t count, double confidence) {
  const double tail = 0.5 * (1.0 - confidence);
  const auto k = static_cast<double>(successes), n = static_cast<double>(count);
  return {successes == 0 ? 0.0 : beta_quantile(tail, k, n - k + 1.0),
          successes == count ? 1.0 : beta_quantile(1.0 - tail, k + 1.0, n - k)};
}

RankInterval quantile_ranks(std::size_t count, double share, double confidence) {
  if (count == 0 || share <= 0.0 || share >= 1.0) return {};
  const double tail = 0.5 * (1.0 - confidence);
  RankInterval ranks;
  if (const std::size_t low = largest_rank(count, share, tail); low > 0) ranks.low = low - 1;
  // The upper rank follows by symmetry.
  if (const std::size_t high = largest_rank(count, 1.0 - share, tail); high > 0) ranks.high = count - high;
  return ranks;
}

// All n values are on one side of the quantile with the probability share^n or (1 - share)^n.
std::size_t values_for_both_ranks(double share, double confidence) {
  const auto both = [&](std::size_t count) {
    const RankInterval ranks = quantile_ranks(count, share, confidence);
    return ranks.low && ranks.high;
  };
  const double rarer = std::max(share, 1.0 - share);
  const double estimate = std::log(0.5 * (1.0 - confidence)) / std::log(rarer);
  auto count = static_cast<std::size_t>(std::max(1.0, std::floor(estimate) - 1.0));
  while (!both(count)) ++count;
  return count;
}

}  // namespace stepwire::statistics

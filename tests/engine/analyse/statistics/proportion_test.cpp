#include "engine/analyse/statistics/proportion.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace stepwire::statistics {

TEST_CASE("the interval of a proportion is that of Clopper and Pearson") {
  // R: binom.test(8, 10)$conf.int; the others have closed forms.
  const ConfidenceInterval eight = proportion_interval(8, 10, 0.95);
  CHECK(eight.low == Approx(0.4439045).epsilon(1e-6));
  CHECK(eight.high == Approx(0.9747893).epsilon(1e-6));
  const ConfidenceInterval none = proportion_interval(0, 10, 0.95);
  CHECK(none.low == 0.0);
  CHECK(none.high == Approx(1.0 - std::pow(0.025, 0.1)));
  const ConfidenceInterval all = proportion_interval(10, 10, 0.95);
  CHECK(all.low == Approx(std::pow(0.025, 0.1)));
  CHECK(all.high == 1.0);
}

TEST_CASE("an interval of a proportion holds its confidence, by counting") {
  constexpr double p = 0.3;
  constexpr int n = 25;
  double covered = 0.0, chance = std::pow(1.0 - p, n);
  for (int k = 0; k <= n; ++k) {
    const ConfidenceInterval interval = proportion_interval(static_cast<std::size_t>(k), n, 0.9);
    if (interval.low <= p && p <= interval.high) covered += chance;
    chance *= p / (1.0 - p) * (n - k) / (k + 1);
  }
  CHECK(covered >= 0.9);
  CHECK(covered < 0.97);
}

TEST_CASE("the interval of a quantile lies between order statistics") {
  // Of 100 values the median is between the 40th and the 61st with 95 % (Conover: Practical Nonparametric
  // Statistics, 3.2). The probability 0.0284 of 40 or fewer is too much, 0.0176 of 39 or fewer is not.
  const RankInterval median = quantile_ranks(100, 0.5, 0.95);
  CHECK(median.low == 39);
  CHECK(median.high == 60);
  // Of ten values the largest is above the 95 % quantile with 1 - 0.95^10 = 40 % only.
  CHECK_FALSE(quantile_ranks(10, 0.95, 0.95).high);
  // With 97.5 % one of n values is above it from 0.95^n <= 0.025 on, which is 72.
  CHECK_FALSE(quantile_ranks(71, 0.95, 0.95).high);
  CHECK(quantile_ranks(72, 0.95, 0.95).high == 71);
}

}  // namespace stepwire::statistics

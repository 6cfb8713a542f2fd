#include "engine/simulate/realtime/measurements.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace stepwire::realtime {

namespace {

/// Times over nine decades, as many in each.
std::vector<std::int64_t> times() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(0.0, 9.0);
  std::vector<std::int64_t> times(20'000);
  for (auto& time : times) time = static_cast<std::int64_t>(std::pow(10.0, exponent(random)));
  return times;
}

}  // namespace

TEST_CASE("bins follow each other without a gap, none wider than a 128th of where it begins") {
  Histogram histogram;
  for (std::size_t bin = 0; bin + 1 < Histogram::bins(); ++bin) {
    const std::int64_t begin = Histogram::begin_of(bin), next = Histogram::begin_of(bin + 1);
    REQUIRE(next > begin);
    REQUIRE((next - begin == 1 ||
             static_cast<double>(next - begin) <= Histogram::resolution * static_cast<double>(begin)));
    histogram.add(begin);
    histogram.add(next - 1);
    REQUIRE(histogram.count_in(bin) == 2);
  }
}

TEST_CASE("a quantile is that of the sorted times, to the resolution and never below") {
  auto sorted = times();
  Histogram histogram;
  for (const auto time : sorted) histogram.add(time);
  std::sort(sorted.begin(), sorted.end());
  for (const double fraction : {0.001, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    INFO(fraction);
    const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(sorted.size())));
    const auto exact = static_cast<double>(sorted[rank - 1]);
    const auto shown = static_cast<double>(histogram.quantile(fraction));
    CHECK(shown >= exact);
    CHECK(shown <= exact * (1.0 + Histogram::resolution));
  }
}

TEST_CASE("count, mean and extremes are exact") {
  Histogram histogram;
  CHECK(histogram.quantile(0.5) == 0);
  CHECK(histogram.mean() == 0.0);
  CHECK(histogram.min() == 0);
  for (const std::int64_t time : {1'000'003, 12'345, 777, 700'000'001}) histogram.add(time);
  CHECK(histogram.count() == 4);
  CHECK(histogram.min() == 777);
  CHECK(histogram.max() == 700'000'001);
  CHECK(histogram.mean() == (1'000'003 + 12'345 + 777 + 700'000'001) / 4.0);
  CHECK(histogram.quantile(1.0) == 700'000'001);
}

TEST_CASE("what is below 0 or beyond the last bin is counted all the same") {
  Histogram histogram;
  histogram.add(-5);
  CHECK(histogram.count_in(0) == 1);
  const std::int64_t hours = 10'000'000'000'000;
  histogram.add(hours);
  CHECK(histogram.count_in(Histogram::bins() - 1) == 1);
  CHECK(histogram.quantile(1.0) == hours);
}

}  // namespace stepwire::realtime

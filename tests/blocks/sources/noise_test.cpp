#include <catch2/catch.hpp>
#include <cmath>

#include "engine/base/math/normal_quantile.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

struct Moments {
  double mean = 0.0, variance = 0.0, kurtosis = 0.0,
         neighbours = 0.0;  ///< neighbours: correlation of one step
};

Moments moments(const std::vector<double>& x) {
  Moments m;
  const auto n = static_cast<double>(x.size());
  for (double v : x) m.mean += v / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = x[i] - m.mean;
    m.variance += d * d / n;
    m.kurtosis += d * d * d * d / n;
    if (i > 0) m.neighbours += d * (x[i - 1] - m.mean) / n;
  }
  m.kurtosis /= m.variance * m.variance;
  m.neighbours /= m.variance;
  return m;
}

std::vector<double> noise(const std::string& keys) {
  const table::Table run =
      run_text("step: 1 ms\nstop: 199.999 s\nblocks:\n  w: {block: Noise, " + keys + "}\nrecord: [w]\n");
  return column(run, "w");
}

}  // namespace

TEST_CASE("normal noise has the moments of a normal distribution and no memory") {
  const Moments m = moments(noise("seed: 7, mean: 3, deviation: 2"));
  // Bounds of five standard errors for 200,000 samples.
  REQUIRE(m.mean == Approx(3.0).margin(0.023));
  REQUIRE(m.variance == Approx(4.0).margin(0.065));
  REQUIRE(m.kurtosis == Approx(3.0).margin(0.055));
  REQUIRE(std::abs(m.neighbours) < 0.012);
}

TEST_CASE("uniform noise has the same deviation and ends") {
  const auto x = noise("seed: 7, distribution: uniform, deviation: 2");
  const Moments m = moments(x);
  REQUIRE(m.mean == Approx(0.0).margin(0.023));
  REQUIRE(m.variance == Approx(4.0).margin(0.04));
  REQUIRE(m.kurtosis == Approx(1.8).margin(0.02));
  for (double v : x) REQUIRE(std::abs(v) < 2.0 * std::sqrt(3.0));
}

TEST_CASE("power over the period is the variance of a sample") {
  REQUIRE(moments(noise("seed: 1, power: 0.004")).variance == Approx(4.0).margin(0.065));
}

TEST_CASE("noise is held through its period and the same for the same seed") {
  const table::Table run = run_text(R"(
step: 1 ms
stop: 50 ms
blocks:
  a: {block: Noise, seed: 5, every: 10 ms}
  b: {block: Noise, seed: 5, every: 10 ms}
  c: {block: Noise, seed: 6, every: 10 ms}
record: [a, b, c]
)");
  const auto &a = column(run, "a"), &c = column(run, "c");
  REQUIRE(a == column(run, "b"));
  for (std::size_t i = 0; i < a.size(); ++i) {
    REQUIRE(a[i] == normal_quantile(to_unit_interval(random_bits(random_bits(5, 0), i / 10))));
    REQUIRE(a[i] != c[i]);
  }
}

TEST_CASE("noise with a deviation and a power is refused, and so is noise without a seed") {
  const std::string frame = "step: 1 ms\nstop: 1 s\nrecord: [w]\nblocks:\n  w: ";
  REQUIRE_THAT(error_of(frame + "{block: Noise, seed: 1, power: 1, deviation: 2}\n"),
               Catch::Contains("give one of them"));
  REQUIRE_THAT(error_of(frame + "{block: Noise}\n"), Catch::Contains("seed"));
}

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

table::Table estimated(const std::string& wiring, const std::string& stop = "40 s") {
  return run_text("step: 100 ms\nstop: " + stop + "\nblocks:\n" + wiring +
                  "record: [e.estimate, e.covariance]\n");
}

const std::string resting = "  s: {block: Constant, value: 0}\n";

}  // namespace

TEST_CASE("Of a drift that rests, precisions of all channels and of what was known before add up") {
  const table::Table run =
      estimated(resting +
                "  e: {block: DriftEstimator, measured: [3, 7], precision: [0.5, 2], direction: [1, 0], "
                "along: s, deviation: 2, correlation: 1}\n");
  const auto &x = column(run, "e.estimate.1"), &variance = column(run, "e.covariance.1");
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double looks = static_cast<double>(k) + 1.0, precision = 1.0 / 4.0 + looks * 2.5;
    REQUIRE(1.0 / variance[k] == Approx(precision).epsilon(1e-12));
    REQUIRE(x[k] == Approx(looks * (0.5 * 3.0 + 2.0 * 7.0) / precision).epsilon(1e-12));
  }
  CHECK(column(run, "e.estimate.2").back() == 0.0);
  CHECK(column(run, "e.covariance.3").back() == 4.0);
}

TEST_CASE("A drift that goes on is known to the steady solution of the Riccati equation") {
  const double r = std::exp(-0.1 / 0.5), fresh = 4.0 * (1.0 - r * r), precision = 3.0;
  const table::Table run = estimated(
      "  s: {block: Clock}\n  e: {block: DriftEstimator, measured: [1], precision: [3], "
      "direction: [0, 1], along: s, deviation: 2, correlation: 0.5 s}\n");
  // P = 1/(1/(r^2 P + q) + p), which is p r^2 P^2 + (p q + 1 - r^2) P - q = 0
  const double b = precision * fresh + 1.0 - r * r, a = precision * r * r;
  CHECK(column(run, "e.covariance.3").back() ==
        Approx((-b + std::sqrt(b * b + 4.0 * a * fresh)) / (2.0 * a)).epsilon(1e-12));
  CHECK(column(run, "e.covariance.1").back() == Approx(4.0).epsilon(1e-12));
}

TEST_CASE("What turns is seen from all sides in turn, and found") {
  const table::Table run = estimated(
      resting +
      "  a: {block: Ramp, slope: 1}\n  x: {block: Trig, u: a, function: cos}\n  y: {block: Trig, u: a}\n"
      "  d: {block: Mux, u: [x, y]}\n  z: {block: Dot, u: [d, [3, -5]]}\n"
      "  e: {block: DriftEstimator, measured: [z], precision: [1e6], direction: d, along: s, "
      "deviation: 10, correlation: 1}\n");
  CHECK(column(run, "e.estimate.1").back() == Approx(3.0).epsilon(1e-5));
  CHECK(column(run, "e.estimate.2").back() == Approx(-5.0).epsilon(1e-5));
}

TEST_CASE("Its error is as large as its covariance says") {
  const table::Table run = run_text(R"(
step: 100 ms
stop: 4000 s
blocks:
  s:     {block: Clock}
  w1:    {block: Noise, seed: 4, deviation: 0.6169684}    # of a process of deviation 2: 2 sqrt(1 - r^2), r = exp(-0.05)
  w2:    {block: Noise, seed: 5, deviation: 0.6169684}
  d1:    {block: DiscreteTransferFunction, u: w1, numerator: [1, 0], denominator: [1, -0.9512294]}
  d2:    {block: DiscreteTransferFunction, u: w2, numerator: [1, 0], denominator: [1, -0.9512294]}
  drift: {block: Mux, u: [d1, d2]}
  noise: {block: Noise, seed: 9, deviation: 0.5}
  a:     {block: Ramp, slope: 1}
  x:     {block: Trig, u: a, function: cos}
  y:     {block: Trig, u: a}
  d:     {block: Mux, u: [x, y]}
  true:  {block: Dot, u: [drift, d]}
  z:     {block: Sum, u: [true, noise]}
  e:     {block: DriftEstimator, measured: [z], precision: [4], direction: d, along: s, deviation: 2, correlation: 2 s}
record: [drift, e.estimate, e.covariance]
)");
  const auto &is = column(run, "drift.1"), &found = column(run, "e.estimate.1"),
             &says = column(run, "e.covariance.1");
  double square = 0.0, expected = 0.0;
  for (std::size_t k = 0; k < is.size(); ++k) {
    square += std::pow(is[k] - found[k], 2);
    expected += says[k];
  }
  CHECK(square / expected == Approx(1.0).margin(0.1));
}

TEST_CASE("A channel of precision 0 says nothing, whatever it measures") {
  const table::Table run = estimated(
      resting +
      "  e: {block: DriftEstimator, measured: [3, 1e300], precision: [1, 0], direction: [1, 0], along: s}\n");
  CHECK(column(run, "e.estimate.1").front() == Approx(1.5));
}

TEST_CASE("Each channel has its own precision") {
  CHECK_THAT(error_of("step: 1 s\nstop: 1 s\nrecord: [e.estimate]\nblocks:\n  e: {block: DriftEstimator, "
                      "measured: [3, 4], "
                      "precision: [1], direction: [1, 0], along: 0}\n"),
             Catch::Contains("1 number for 2 channels"));
}

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A wall of 5 N and 1 N/mm, 1.5 mm from the middle, entered at 1 s with `rate`; what is felt rises by
/// `rise`.
table::Table felt(const std::string& rate, const std::string& rise, const std::string& before = "1 N") {
  return run_text("step: 100 ms\nstop: 3 s\nblocks:\n  on: {block: Step, time: 1 s, before: " + before +
                  ", after: 5 N}\n"
                  "  up: {block: Ramp, start: 1 s, slope: " +
                  rise +
                  "}\n  f: {block: Sum, u: [on, up]}\n"
                  "  w: {block: WallSense, resistance: f, free: 1 N, rate: " +
                  rate +
                  ", weber: 0.1, threshold: 0.04 N, just: 3, wrong: 1 mm/s, offset: 5 N, slope: 1 N/mm, "
                  "half: 1.5 mm, every: 100 ms}\n"
                  "record: [w.outside, w.side, w.measured, w.precision]\n");
}

}  // namespace

TEST_CASE("Inside of the corridor nothing is said") {
  const table::Table run = felt("1 mm/s", "1 N/s");
  for (std::size_t k = 0; k < 10; ++k) {
    REQUIRE(column(run, "w.outside")[k] == 0.0);
    REQUIRE(column(run, "w.precision")[k] == 0.0);
  }
  CHECK(column(run, "w.outside")[10] == 1.0);
}

TEST_CASE("The side is that of the motion as it leaves, as surely as its rate is known") {
  // the probability that a rate of 1 mm/s with an error of 1 mm/s is above 0 is 0.841
  CHECK(column(felt("1 mm/s", "0 N/s"), "w.side")[10] == Approx(2.0 * 0.8413 - 1.0).margin(0.02));
  CHECK(column(felt("-1 mm/s", "0 N/s"), "w.side")[10] == Approx(1.0 - 2.0 * 0.8413).margin(0.02));
  CHECK(column(felt("0 mm/s", "0 N/s"), "w.side")[10] == 0.0);
}

TEST_CASE(
    "Resistance that rises with the way outward confirms the outer side, with that inward the inner one") {
  CHECK(column(felt("0.5 mm/s", "0.5 N/s"), "w.side").back() >
        column(felt("0.5 mm/s", "0.5 N/s"), "w.side")[10]);
  CHECK(column(felt("0.5 mm/s", "0.5 N/s"), "w.measured").back() == Approx(2.5e-3).epsilon(0.25));
  CHECK(column(felt("-0.5 mm/s", "0.5 N/s"), "w.side").back() < -0.8);
}

TEST_CASE("Where the side is not known the other one is in the variance") {
  const table::Table run = felt("0 mm/s", "0 N/s");
  CHECK(column(run, "w.measured").back() == 0.0);
  CHECK(1.0 / std::sqrt(column(run, "w.precision").back()) ==
        Approx(std::hypot(1.5e-3, 0.5016e-3)).epsilon(1e-3));
}

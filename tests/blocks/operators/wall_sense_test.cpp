#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A wall of 5 N and 1 N/mm, 1.5 mm from the middle, entered at 1 s with `rate`; what is felt rises by
/// `rise`.
table::Table felt(const std::string& rate, const std::string& rise, const std::string& more = "free: 0.1 N",
                  const std::string& before = "0.1 N") {
  return run_text("step: 100 ms\nstop: 3 s\nblocks:\n  on: {block: Step, time: 1 s, before: " + before +
                  ", after: 5 N}\n"
                  "  up: {block: Ramp, start: 1 s, slope: " +
                  rise +
                  "}\n  f: {block: Sum, u: [on, up]}\n"
                  "  w: {block: WallSense, resistance: f, rate: " +
                  rate + ", " + more +
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
  // 6 N are felt 2.5 mm from the middle.
  CHECK(column(felt("0.5 mm/s", "0.5 N/s"), "w.measured").back() ==
        Approx(2.5e-3 * column(felt("0.5 mm/s", "0.5 N/s"), "w.side").back()));
  CHECK(column(felt("-0.5 mm/s", "0.5 N/s"), "w.side").back() ==
        Approx(-column(felt("0.5 mm/s", "0.5 N/s"), "w.side").back()));
}

TEST_CASE("Where the side is not known the other one is in the variance, and what a free motion resists") {
  const auto deviation = [](const table::Table& run) {
    return 1.0 / std::sqrt(column(run, "w.precision").back());
  };
  const table::Table run = felt("0 mm/s", "0 N/s");
  CHECK(column(run, "w.measured").back() == 0.0);
  CHECK(deviation(run) == Approx(std::hypot(1.5e-3, 0.5016e-3, 0.1e-3)).epsilon(1e-3));
  CHECK(deviation(felt("0 mm/s", "0 N/s", "free: 2 N")) ==
        Approx(std::hypot(1.5e-3, 0.5016e-3, 2e-3)).epsilon(1e-3));
}

TEST_CASE("A wall that may have been there before tells its side as rarely as it was entered") {
  // 1 of 10 is entered: 0.5 + 0.1 (0.841 - 0.5)
  CHECK(column(felt("1 mm/s", "0 N/s", "free: 0.1 N, entered: 0.1"), "w.side")[10] ==
        Approx(0.1 * (2.0 * 0.8413 - 1.0)).margin(0.002));
  CHECK(column(felt("100 mm/s", "0 N/s", "free: 0.1 N, entered: 0.1"), "w.side")[10] ==
        Approx(0.1).margin(1e-6));
  CHECK(column(felt("100 mm/s", "0 N/s"), "w.side")[10] == Approx(std::tanh(4.0)));
}

TEST_CASE("What is felt for longer is no surer for that, since its error stays") {
  // The hand leaves at 1 mm/s and stops 0.1 mm further out; the felt force stays the same.
  const table::Table run = run_text(
      "step: 100 ms\nstop: 3 s\nblocks:\n  f: {block: Step, time: 1 s, before: 0 N, after: 5.1 N}\n"
      "  r: {block: Step, time: 1.15 s, before: 1 mm/s, after: 0 mm/s}\n"
      "  w: {block: WallSense, resistance: f, free: 0.1 N, rate: r, weber: 0.1, threshold: 0.04 N, just: 3, "
      "wrong: 0.001 mm/s, offset: 5 N, slope: 1 N/mm, half: 1.5 mm, entered: 0.1, every: 100 ms}\n"
      "record: [w.side]\n");
  const auto& side = column(run, "w.side");
  CHECK(side[11] > side[10]);
  CHECK(side[29] == Approx(side[12]).epsilon(1e-4));
}

TEST_CASE("Resistance that may be that of a free motion says less of the side") {
  const auto side = [](const std::string& free) {
    return column(felt("0.5 mm/s", "0.5 N/s", free), "w.side").back();
  };
  CHECK(side("free: 0.1 N") > side("free: 1 N") + 0.005);
  CHECK(side("free: 1 N") > side("free: 3 N") + 0.01);
}

TEST_CASE("A held hand knows that a wall resists what it pushes or more, and no more") {
  
  const auto side = [](const std::string& rise, const std::string& held) {
    return column(felt("0.5 mm/s", rise, "free: 0.1 N, held: " + held), "w.side").back();
  };
  // Behind a push of 6 N the wall is stronger than on its boundary.
  CHECK(side("0.5 N/s", "1") > side("0 N/s", "1"));
  // Against a wall of 5 N a held hand pushes with 2 N, and its side stays as unknown as before.
  const auto weak = [](const std::string& held) {
    const table::Table run = run_text(
        "step: 100 ms\nstop: 2 s\nblocks:\n  f: {block: Step, time: 1 s, before: 0 N, after: 2 N}\n"
        "  w: {block: WallSense, resistance: f, free: 0.1 N, rate: 0.5 mm/s, held: " +
        held +
        ", weber: 0.1, threshold: 0.04 N, just: 3, wrong: 1 mm/s, offset: 5 N, slope: 1 N/mm, half: 1.5 mm, "
        "every: 100 ms}\n"
        "record: [w.side]\n");
    return column(run, "w.side");
  };
  CHECK(weak("1").back() == Approx(weak("1")[10]).margin(0.01));
  CHECK(std::abs(weak("0").back() - weak("0")[10]) > 0.02);
}

#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

// scipy 1.10.1: b, a = signal.butter(3, 0.2); signal.lfilter(b, a, [1, 0, 0, 0, 0, 0, 0, 0])
TEST_CASE("The impulse response of a Butterworth filter agrees with SciPy") {
  const table::Table table = run_text(R"(
step: 1 s
stop: 7 s
blocks:
  u: {block: Step, time: 0.5, before: 1, after: 0}
  filter:
    block: DiscreteTransferFunction
    numerator: [0.018098933007514435, 0.05429679902254331, 0.05429679902254331, 0.018098933007514435]
    denominator: [1.0, -1.7600418803431688, 1.1828932620378305, -0.2780599176345463]
    u: u
record: [filter]
)");
  const double expected[] = {0.018098933007514435, 0.08615167910529406, 0.18451825640508343,
                             0.24598313906280533,  0.23863055318036902, 0.18033510093266772,
                             0.1035209080512797,   0.035237549821661523};
  for (std::size_t k = 0; k < 8; ++k) CHECK(column(table, "filter")[k] == Approx(expected[k]).margin(1e-15));
}

TEST_CASE("The default discrete transfer function is a delay by one period") {
  const table::Table table = run_text(R"(
step: 1 s
stop: 4 s
blocks:
  next: {block: Gain, gain: 2, u: z}
  z: {block: DiscreteTransferFunction, u: next, initial: 1}
record: [z]
)");
  CHECK(column(table, "z") == std::vector<double>{1, 2, 4, 8, 16});
}

TEST_CASE("A discrete lag follows a step geometrically") {
  const table::Table table = run_text(R"(
step: 1 s
stop: 5 s
blocks:
  lag: {block: DiscreteTransferFunction, numerator: [0.25], denominator: [0.5, -0.25], u: 1}
record: [lag]
)");
  double power = 1.0;
  for (double y : column(table, "lag")) {
    CHECK(y == Approx(1.0 - power).margin(1e-15));
    power *= 0.5;
  }
}

TEST_CASE(
    "The output of a discrete transfer function has the unit of its coefficients times that of its input") {
  const table::Table table = run_text(R"(
step: 1 s
stop: 1 s
blocks:
  f: {block: Constant, value: 2 N}
  filter: {block: DiscreteTransferFunction, numerator: [0.1 m/N], denominator: [1, 0], u: f}
record: [filter]
)");
  REQUIRE(table.find("filter") != nullptr);
  CHECK(table.find("filter")->unit == "m");
  CHECK(column(table, "filter").back() == Approx(0.2));
}

TEST_CASE("A discrete transfer function that looks ahead is refused") {
  CHECK_THAT(
      error_of("step: 1 s\nstop: 1 s\nblocks:\n"
               "  z: {block: DiscreteTransferFunction, numerator: [1, 0, 0], denominator: [1, 0], u: 1}\n"),
      Catch::Contains("z.denominator") && Catch::Contains("degree 2"));
}

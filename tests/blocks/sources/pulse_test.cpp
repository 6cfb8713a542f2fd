#include <catch2/catch.hpp>
#include <numeric>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("pulses are high in the first part of each period after the delay") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 1.2 s
blocks:
  y: {block: Pulse, amplitude: 2, period: 0.5 s, width: 40 %, delay: 0.2 s, bias: -1}
record: [y]
)");
  REQUIRE(column(run, "y") == std::vector<double>{-1, -1, 1, 1, -1, -1, -1, 1, 1, -1, -1, -1, 1});
}

TEST_CASE("edges of pulses fall on their ticks through a long run") {
  const table::Table run = run_text(R"(
step: 1 ms
stop: 99.999 s
blocks:
  y: {block: Pulse, period: 7 ms, width: 0.42857142857142855}
record: [y]
)");
  const auto& y = column(run, "y");
  for (std::size_t i = 0; i < y.size(); ++i) REQUIRE(y[i] == (i % 7 < 3 ? 1.0 : 0.0));
}

TEST_CASE("a pulse as wide as its period never falls, and one without width never rises") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 3 s
blocks:
  wide: {block: Pulse, period: 0.3 s, width: 1}
  none: {block: Pulse, period: 0.3 s, width: 0}
record: [wide, none]
)");
  REQUIRE(column(run, "wide") == std::vector<double>(31, 1.0));
  REQUIRE(column(run, "none") == std::vector<double>(31, 0.0));
}

TEST_CASE("phase says where in its period a train of pulses begins") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 1.4 s
blocks:
  quarter: {block: Pulse, period: 0.4 s, width: 0.5, phase: 90 deg, delay: 0.2 s}
  late: {block: Pulse, period: 0.4 s, width: 0.5, phase: -90 deg}
  turns: {block: Pulse, period: 0.4 s, width: 0.5, phase: 630 deg}
record: [quarter, late, turns]
)");
  const std::vector<double> quarter{0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1},
      late{0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};
  CHECK(column(run, "quarter") == quarter);
  CHECK(column(run, "late") == late);
  CHECK(column(run, "turns") == late);
}

TEST_CASE("edges of pulses with a phase split a located step") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 1 s
solver: rk4
events: locate
blocks:
  y: {block: Pulse, period: 0.25 s, width: 0.3, delay: 0.07 s, phase: 36 deg}
  x: {block: Integrator, u: y}
record: [x]
)");
  // 0.05 s of the first pulse, 0.075 s of those that rise at 0.295 s, 0.545 s, 0.795 s.
  CHECK(column(run, "x").back() == Approx(0.05 + 3.0 * 0.075).epsilon(1e-12));
}

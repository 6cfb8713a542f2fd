#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A unit delay gives the input of one period ago, element by element") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 1 s
blocks:
  a: {block: Sine, frequency: 1.7}
  b: {block: Ramp, slope: 3}
  u: {block: Mux, u: [a, b], every: 20 ms}
  late: {block: UnitDelay, u: u, initial: [5, -5]}
record: {every: 20 ms, signals: [u, late]}
)");
  CHECK(column(table, "late.1")[0] == 5.0);
  CHECK(column(table, "late.2")[0] == -5.0);
  for (std::size_t k = 1; k < table.rows(); ++k) {
    CHECK(column(table, "late.1")[k] == column(table, "u.1")[k - 1]);
    CHECK(column(table, "late.2")[k] == column(table, "u.2")[k - 1]);
  }
}

TEST_CASE("A unit delay cuts an algebraic loop") {
  const table::Table table = run_text(R"(
step: 1 s
stop: 6 s
blocks:
  next: {block: Gain, gain: 2, u: count}
  count: {block: UnitDelay, u: next, initial: 3}
record: [count]
)");
  CHECK(column(table, "count") == std::vector<double>{3, 6, 12, 24, 48, 96, 192});
}

TEST_CASE("A zero-order hold keeps the sample of its own tick") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 100 ms
blocks:
  t: {block: Clock}
  held: {block: ZeroOrderHold, u: t, every: 7 ms}
record: [held]
)");
  for (std::size_t k = 0; k < table.rows(); ++k)
    CHECK(column(table, "held")[k] == Approx(7e-3 * std::floor(static_cast<double>(k) / 7.0)).margin(1e-15));
}

TEST_CASE("A delay gives its input as it was, and its initial value until then") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 300 ms
blocks:
  a: {block: Sine, frequency: 9}
  b: {block: Ramp, slope: 1}
  u: {block: Mux, u: [a, b]}
  late: {block: Delay, u: u, delay: 35 ms, initial: [2, -1], every: 5 ms}
record: {every: 5 ms, signals: [late]}
)");
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double before = 5e-3 * static_cast<double>(k) - 0.035;
    const double sine = k < 7 ? 2.0 : std::sin(18.0 * std::acos(-1.0) * before);
    CHECK(column(table, "late.1")[k] == Approx(sine).margin(1e-12));
    CHECK(column(table, "late.2")[k] == Approx(k < 7 ? -1.0 : before).margin(1e-12));
  }
}

TEST_CASE("A delay of one period is a unit delay") {
  const table::Table table = run_text(R"(
step: 1 s
stop: 4 s
blocks:
  next: {block: Gain, gain: 2, u: count}
  count: {block: Delay, delay: 1 s, u: next, initial: 1}
record: [count]
)");
  CHECK(column(table, "count") == std::vector<double>{1, 2, 4, 8, 16});
}

TEST_CASE("A delay and a window of no whole periods are refused with both numbers") {
  const std::string head = "step: 1 ms\nstop: 1 s\nblocks:\n  t: {block: Clock}\n";
  CHECK_THAT(error_of(head + "  d: {block: Delay, delay: 2.5 ms, u: t}\n"),
             Catch::Contains("d.delay") && Catch::Contains("0.0025 s") && Catch::Contains("0.001 s"));
  CHECK_THAT(error_of(head + "  m: {block: MovingAverage, window: 0.2 ms, u: t}\n"),
             Catch::Contains("m.window"));
}

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Area that a loop encloses from row `from` on, one period long, positive where it is run clockwise.
double loop_area(const std::vector<double>& x, const std::vector<double>& y, std::size_t from) {
  double area = 0.0;
  for (std::size_t k = from; k + 1 < x.size(); ++k) area += 0.5 * (y[k] + y[k + 1]) * (x[k + 1] - x[k]);
  return area;
}

}  // namespace

TEST_CASE("A rate limiter makes ramps of a step, up and down") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 4 s
blocks:
  u: {block: Step, time: 2, before: 3, after: 0}
  y: {block: RateLimiter, rising: 2, falling: -4, u: u, initial: 1, every: 10 ms}
record: {every: 10 ms, signals: [y]}
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double t = time[k];  // the fall starts at the tick of the step, from the value of the tick before
    const double expected = k < 200 ? std::min(1.0 + 2.0 * t, 3.0) : std::max(3.0 - 4.0 * (t - 1.99), 0.0);
    CHECK(column(table, "y")[k] == Approx(expected).margin(1e-9));
  }
}

TEST_CASE("A rate limiter lets pass what is slow enough") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
blocks:
  u: {block: Sine, frequency: 1, amplitude: 0.1}
  y: {block: RateLimiter, rising: 0.63, falling: -0.63, u: u}
record: [u, y]
)");
  CHECK(column(table, "y") == column(table, "u"));
}

TEST_CASE("The loop of a backlash has the area of its parallelogram") {
  // Amplitude a, gap w: the output swings by 2 (a - w/2), each way w behind: area 2 w (a - w/2).
  const table::Table table = run_text(R"(
step: 0.1 ms
stop: 2 s
blocks:
  u: {block: Sine, frequency: 1, amplitude: 3}
  y: {block: Backlash, width: 0.8, u: u}
record: [u, y]
)");
  const double area = loop_area(column(table, "u"), column(table, "y"), 10000);
  CHECK(std::abs(area) == Approx(2.0 * 0.8 * (3.0 - 0.4)).epsilon(1e-4));
  CHECK(area < 0.0);  // the output lags behind
}

TEST_CASE("A backlash moves only where it is pushed") {
  const table::Table table = run_text(R"(
step: 1
stop: 7
blocks:
  t: {block: Clock}
  u: {block: Expression, expression: "u < 3.5 ? u : 7 - u", u: t}
  y: {block: Backlash, width: 1, u: u, initial: -2}
record: [y]
)");
  CHECK(column(table, "y") == std::vector<double>{-0.5, 0.5, 1.5, 2.5, 2.5, 2.5, 1.5, 0.5});
}

TEST_CASE("The loop of a relay is a rectangle between its thresholds") {
  const table::Table table = run_text(R"(
step: 0.1 ms
stop: 2 s
blocks:
  u: {block: Sine, frequency: 1, amplitude: 3}
  y: {block: Relay, switch_on: 1.5, switch_off: -0.5, when_on: 4, when_off: -1, u: u}
record: [u, y]
)");
  const double area = loop_area(column(table, "u"), column(table, "y"), 10000);
  CHECK(std::abs(area) == Approx((1.5 + 0.5) * (4.0 + 1.0)).epsilon(1e-3));
}

TEST_CASE("A relay keeps its initial state between the thresholds, and switches on them") {
  const std::string head = "step: 1\nstop: 4\nblocks:\n  t: {block: Clock}\n";
  const auto run = [&](const std::string& expression, const std::string& initial) {
    return column(
        run_text(
            head + "  u: {block: Expression, expression: " + expression + ", u: t}\n" +
            "  y: {block: Relay, switch_on: 2, switch_off: 0, when_on: 10, when_off: 5, u: u, initial: " +
            initial + "}\nrecord: [y]\n"),
        "y");
  };
  CHECK(run("\"1\"", "1") == std::vector<double>{10, 10, 10, 10, 10});
  CHECK(run("\"1\"", "0") == std::vector<double>{5, 5, 5, 5, 5});
  CHECK(run("\"u\"", "0") == std::vector<double>{5, 5, 10, 10, 10});
  CHECK(run("\"3 - u\"", "0") == std::vector<double>{10, 10, 10, 5, 5});
}

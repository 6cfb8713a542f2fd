#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("An integrator of a ramp is a parabola, from its initial value on") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 2 s
solver: rk4
blocks:
  ramp: {block: Ramp, slope: 3}
  x: {block: Integrator, u: ramp, initial: -1}
record: [x]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); ++k)
    CHECK(column(table, "x")[k] == Approx(1.5 * time[k] * time[k] - 1.0).margin(1e-12));
}

TEST_CASE("An integrator takes vectors and says the unit of its integral") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 1 s
solver: rk4
blocks:
  u: {block: Constant, value: {value: [1, -2], unit: N}}
  x: {block: Integrator, u: u, initial: {value: [0, 5], unit: N s}}
record: [x]
)");
  CHECK(column(table, "x.1").back() == Approx(1.0));
  CHECK(column(table, "x.2").back() == Approx(3.0));
  CHECK(table.find("x.1")->unit == "N s");
}

TEST_CASE("An integrator may feed itself, since its output does not depend on its input at once") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 3 s
solver: rk4
blocks:
  down: {block: Gain, gain: -1 1/s, u: x}
  x: {block: Integrator, u: down, initial: 1}
record: [x]
)");
  CHECK(column(table, "x").back() == Approx(std::exp(-3.0)).epsilon(1e-12));
}

TEST_CASE("An integrator stops at its limit and leaves it at once") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 5 s
solver: rk4
blocks:
  u: {block: Step, time: 2, before: 1, after: -1, every: 10 ms}
  x: {block: Integrator, u: u, lower: -0.5, upper: 1.25}
record: [x, x.x]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double t = time[k];
    const double expected = t < 2.0 ? std::min(t, 1.25) : std::max(1.25 - (t - 2.0), -0.5);
    CHECK(column(table, "x")[k] == Approx(expected).margin(1e-9));
  }
}

TEST_CASE("An integrator that starts beyond a limit shows the limit") {
  const table::Table table = run_text(R"(
step: 10 ms
stop: 1 s
solver: rk4
blocks:
  x: {block: Integrator, u: 0, lower: -1, upper: 1, initial: 7}
record: [x]
)");
  for (double x : column(table, "x")) CHECK(x == 1.0);
}

namespace {

/// The signal is true from 1 s to 1.4 s and from 2 s to 2.4 s; the input is 1.
table::Table reset_run(const std::string& more) {
  return run_text(R"(
step: 100 ms
stop: 3 s
solver: rk4
blocks:
  reset: {block: Pulse, amplitude: 1, period: 1, width: 0.4, delay: 0.95, every: 100 ms}
  x: {block: Integrator, u: 1, reset: reset, initial: 0.5)" +
                  more + "}\nrecord: [x]\n");
}

void check_near(const std::vector<double>& x, std::initializer_list<std::pair<int, double>> expected) {
  for (const auto& [tenths, value] : expected) {
    INFO("at " << tenths << " tenths of a second");
    CHECK(x[static_cast<std::size_t>(tenths)] == Approx(value).margin(1e-12));
  }
}

}  // namespace

TEST_CASE("A reset on the rising edge shows at the same step and goes back to the initial value") {
  const table::Table table = reset_run("");
  check_near(column(table, "x"), {{0, 0.5}, {9, 1.4}, {10, 0.5}, {11, 0.6}, {19, 1.4}, {20, 0.5}, {30, 0.5}});
}

TEST_CASE("A reset on the falling edge goes to the value that is wired") {
  const table::Table table = reset_run(", trigger: falling, value: -2");
  check_near(column(table, "x"),
             {{10, 1.5}, {13, 1.8}, {14, -2.0}, {15, -1.9}, {23, -1.1}, {24, -2.0}, {30, -1.4}});
}

TEST_CASE("A reset on either edge acts twice per pulse") {
  const table::Table table = reset_run(", trigger: either, value: 0");
  check_near(column(table, "x"),
             {{9, 1.4}, {10, 0.0}, {13, 0.3}, {14, 0.0}, {19, 0.5}, {20, 0.0}, {24, 0.0}});
}

TEST_CASE("A reset by level holds until it is released") {
  const table::Table table = reset_run(", trigger: level, value: 0");
  check_near(column(table, "x"),
             {{9, 1.4}, {10, 0.0}, {12, 0.0}, {13, 0.0}, {14, 0.0}, {15, 0.1}, {19, 0.5}});
}

TEST_CASE("An integrator refuses crossed limits and a value without a reset") {
  const std::string head = "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n";
  CHECK_THAT(error_of(head + "  x: {block: Integrator, u: 1, lower: 2, upper: 1}\n"),
             Catch::Contains("x.lower") && Catch::Contains("2 lies above upper 1"));
  CHECK_THAT(error_of(head + "  x: {block: Integrator, u: 1, value: 2}\n"),
             Catch::Contains("'reset' is missing"));
}

TEST_CASE("An integrator leaves its limit where its input turns, with every solver") {
  const std::string solver =
      GENERATE("heun", "bogacki_shampine", "rk4", "dormand_prince", "rosenbrock", "sdirk", "rodas");
  INFO(solver);
  // u = 1.0874 - 2 t turns at 0.5437 s; from there on x = 0.21 - (t - 0.5437)^2, and upside down.
  const table::Table run = run_text("events: locate\nstep: 100 ms\nstop: 1 s\nsolver: " + solver +
                                    "\nblocks:\n  u: {block: Ramp, slope: -2, initial: 1.0874}\n"
                                    "  v: {block: Gain, u: u, gain: -1}\n"
                                    "  x: {block: Integrator, u: u, upper: 0.21}\n"
                                    "  y: {block: Integrator, u: v, lower: -0.21}\nrecord: [x, y]\n");
  CHECK(column(run, "x").back() == Approx(0.21 - 0.4563 * 0.4563).epsilon(1e-9));
  CHECK(column(run, "y").back() == Approx(0.4563 * 0.4563 - 0.21).epsilon(1e-9));
}

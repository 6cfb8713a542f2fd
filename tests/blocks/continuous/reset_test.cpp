// One mechanism of resets: Integrator has it, and every other block with states that it makes sense for.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/base/yaml/error.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

table::Table run_reset(const std::string& tested, const std::string& more = "") {
  return run_text(fmt::format(R"(
step: 1 ms
stop: 2 s
solver: rk4
blocks:
  r: {{block: Step, time: 1, before: 0, after: 1}}
  tested: {{{}}}
{}
record: [tested]
)",
                              tested, more));
}

}  // namespace

TEST_CASE("A lag that is reset begins anew, at the tick of the reset") {
  const table::Table table = run_reset("block: Lag, u: 3, tau: 0.4, initial: 1, reset: r");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double since = k < 1000 ? time[k] : time[k] - 1.0;
    CHECK(column(table, "tested")[k] == Approx(3.0 - 2.0 * std::exp(-since / 0.4)).epsilon(1e-10));
  }
}

TEST_CASE("A level holds a lag at what is wired to value, and lets it go") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 2 s
solver: rk4
blocks:
  r: {block: Pulse, period: 1 s, width: 0.5}
  five: {block: Constant, value: 5}
  tested: {block: Lag, u: 1, tau: 0.1, reset: r, trigger: level, value: five}
record: [tested]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < 1000; ++k) {
    const double since = std::max(time[k] - 0.5, 0.0);  // from the first tick on that is not of the level
    CHECK(column(table, "tested")[k] == Approx(1.0 + 4.0 * std::exp(-since / 0.1)).epsilon(1e-9));
  }
}

TEST_CASE("initial may be a signal: the state starts there, and a reset goes to where it is then") {
  for (const char* const type : {"Lag", "Integrator", "UnitDelay", "DiscreteIntegrator"}) {
    const table::Table table = run_reset(fmt::format("block: {}, u: 0, initial: from, reset: r", type),
                                         "  from: {block: Ramp, slope: 2, initial: 7}");
    INFO(type);
    CHECK(column(table, "tested")[0] == 7.0);
    CHECK(column(table, "tested")[1000] == Approx(9.0).epsilon(1e-12));
  }
}

TEST_CASE("initial as a signal needs no reset and has the unit of the state") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  from: {block: Constant, value: 4 m}
  tested: {block: Integrator, u: 2 m/s, initial: from}
record: [tested]
)");
  CHECK(column(table, "tested").back() == Approx(6.0));
  CHECK_THROWS_AS(run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  from: {block: Constant, value: 4 N}
  tested: {block: Integrator, u: 2 m/s, initial: from}
record: [tested]
)"),
                  yaml::Error);
}

TEST_CASE("Two integrators in a row, a transfer function and a state space start anew alike") {
  const auto one =
      run_reset("block: TransferFunction, u: 1, numerator: [2], denominator: [1, 0.5, 4], reset: r");
  const auto two =
      run_reset("block: StateSpace, u: 1, A: [[-0.5, -4], [1, 0]], B: [[1], [0]], C: [[0, 2]], reset: r");
  for (std::size_t k = 0; k < 1000; ++k) {
    CHECK(column(one, "tested")[k + 1000] == Approx(column(one, "tested")[k]).margin(1e-14));
    CHECK(column(two, "tested")[k] == Approx(column(one, "tested")[k]).margin(1e-14));
    CHECK(column(two, "tested")[k + 1000] == Approx(column(two, "tested")[k]).margin(1e-14));
  }
}

TEST_CASE("What has a reset repeats itself after one, whatever it is") {
  for (const char* const block :
       {"Derivative, u: 3, tau: 0.1, initial: 0", "Derivative, u: ramp, tau: 0.1, settled: true",
        "PID, u: 0.5, kp: 2, ki: 3, kd: 1, tau: 0.1", "DiscretePID, u: 0.5, kp: 2, ki: 3, kd: 1, tau: 0.1",
        "DiscreteIntegrator, u: 3, method: trapezoidal", "UnitDelay, u: saw", "Delay, u: saw, delay: 5 ms",
        "VariableDelay, u: saw, delay: 2.5 ms, longest: 5 ms", "MovingAverage, u: saw, window: 5 ms",
        "SavitzkyGolay, u: saw", "RateLimiter, u: 10, rising: 3", "Backlash, u: saw, width: 0.1",
        "DiscreteTransferFunction, u: saw, numerator: [1, 0.5], denominator: [1, -0.9]"}) {
    INFO(block);
    // The input repeats itself, too: a sawtooth that restarts at each second.
    const table::Table table =
        run_reset(fmt::format("block: {}, reset: r", block),
                  "  back: {block: Pulse, period: 1 s, width: 0.5}\n"
                  "  saw: {block: Integrator, u: 1, reset: back}\n  ramp: {block: Gain, gain: 2, u: saw}");
    const auto& y = column(table, "tested");
    bool moves = false;
    for (std::size_t k = 0; k < 1000; ++k) {
      CHECK(y[k + 1000] == Approx(y[k]).margin(2e-9));
      moves = moves || y[k] != y[0];
    }
    CHECK(moves);
  }
}

TEST_CASE("A ball whose new speed follows from the speed before the reset is no loop") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 0.6 s
solver: rk4
blocks:
  bounce: {block: Gain, gain: -0.8, u: v.before}
  hit: {block: Compare, operator: "<=", u: x, to: 0}
  v: {block: Integrator, u: -9.81 m/s^2, reset: hit, value: bounce}
  x: {block: Integrator, u: v, initial: 1 m}
record: [v, v.before, x]
)");
  const auto& v = column(table, "v");
  const auto& before = column(table, "v.before");
  // Falls for sqrt(2/9.81) s = 451.5 ms; the tick after that, at 452 ms, throws it back.
  CHECK(before[452] == Approx(-9.81 * 0.452).epsilon(1e-12));
  CHECK(v[452] == Approx(0.8 * 9.81 * 0.452).epsilon(1e-12));
  CHECK(v[453] == Approx(v[452] - 9.81e-3).epsilon(1e-12));
  CHECK(v[451] == before[451]);
}

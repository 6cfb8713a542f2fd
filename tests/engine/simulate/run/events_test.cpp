#include <catch2/catch.hpp>
#include <cmath>

#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

std::string ball(const std::string& head) {
  return head + R"(step: 1 ms
stop: 4 s
blocks:
  v: {block: Integrator, u: -9.81, reset: hit, value: bounce}
  x: {block: Integrator, u: v, initial: 1}
  hit: {block: Compare, u: x, operator: less, to: 0}
  bounce: {block: Gain, gain: -0.8, u: v.before}
record: [x, v]
)";
}

/// Height of a ball of 1 m with restitution 0.8 at a time.
double height(double time) {
  const double g = 9.81;
  double speed = std::sqrt(2.0 * g), left = time - std::sqrt(2.0 / g);
  if (left < 0.0) return 1.0 - 0.5 * g * time * time;
  for (speed *= 0.8; left > 2.0 * speed / g; speed *= 0.8) left -= 2.0 * speed / g;
  return speed * left - 0.5 * g * left * left;
}

double ball_error(const std::string& head) {
  const table::Table run = run_text(ball(head));
  const auto &time = column(run, "time"), &x = column(run, "x");
  REQUIRE(x.size() == 4001);
  double error = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) error = std::max(error, std::abs(x[k] - height(time[k])));
  return error;
}

/// The largest of a recorded column.
double largest(const table::Table& run, const std::string& name) {
  double most = -1e300;
  for (const double value : column(run, name)) most = std::max(most, value);
  return most;
}

}  // namespace

TEST_CASE("a bouncing ball is where its closed form has it, with every solver") {
  for (const char* solver : {"rk4", "heun", "dormand_prince", "rosenbrock"}) {
    INFO(solver);
    CHECK(ball_error(std::string("events: locate\nsolver: ") + solver + "\n") < 1e-8);
  }
  CHECK(ball_error("solver: rk4\n") > 1e-3);
}

TEST_CASE("a relay turns an integrator at its thresholds") {
  const char* const blocks = R"(step: 7 ms
stop: 70 s
solver: rk4
blocks:
  rate: {block: Relay, switch_on: -1, switch_off: -1, when_on: -1, when_off: 1, u: low}
  low: {block: Gain, gain: 1, u: switched}
  switched: {block: Relay, switch_on: 1, switch_off: -1, when_on: 0, when_off: -2, u: x}
  x: {block: Integrator, u: rate}
record: [x]
)";
  // x' is -1 above and 1 below: a triangle between -1 and 1 with a period of 4 s.
  const table::Table run = run_text(std::string("events: locate\n") + blocks);
  const auto &time = column(run, "time"), &x = column(run, "x");
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double phase = std::fmod(time[k] + 1.0, 4.0);
    CHECK(x[k] == Approx(phase < 2.0 ? phase - 1.0 : 3.0 - phase).margin(1e-9));
  }
  CHECK(largest(run_text(blocks), "x") > 1.0005);
}

TEST_CASE("an integrator that resets itself is a sawtooth") {
  const table::Table run = run_text(R"(events: locate
step: 10 ms
stop: 10 s
solver: rk4
blocks:
  x: {block: Integrator, u: 1, reset: full, trigger: level}
  full: {block: Compare, u: x.before, operator: greater_equal, to: 0.7331}
record: [x]
)");
  const auto &time = column(run, "time"), &x = column(run, "x");
  for (std::size_t k = 0; k < x.size(); ++k) CHECK(x[k] == Approx(std::fmod(time[k], 0.7331)).margin(1e-9));
}

TEST_CASE("several events in one step are located one after the other") {
  const table::Table run = run_text(R"(events: locate
step: 1 s
stop: 10 s
solver: rk4
blocks:
  x: {block: Integrator, u: 1, reset: full, trigger: level}
  full: {block: Compare, u: x.before, operator: greater_equal, to: 0.3}
record: [x]
)");
  const auto &time = column(run, "time"), &x = column(run, "x");
  for (std::size_t k = 1; k < x.size(); ++k) {
    const double rest = std::fmod(time[k] + 1e-9, 0.3) - 1e-9;
    CHECK(std::min(std::abs(x[k] - rest), std::abs(x[k] - rest - 0.3)) < 1e-9);
  }
}

TEST_CASE("an integrator stops at its limit and leaves it when its input turns") {
  const table::Table run = run_text(R"(events: locate
step: 50 ms
stop: 6 s
solver: rk4
blocks:
  u: {block: Ramp, slope: -1, initial: 2}
  x: {block: Integrator, u: u, upper: 1}
record: [x]
)");
  const auto &time = column(run, "time"), &x = column(run, "x");
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double t = time[k], free = 2.0 * t - 0.5 * t * t;
    const double limited = t > 2.0 ? 1.0 - 0.5 * (t - 2.0) * (t - 2.0) : std::min(free, 1.0);
    CHECK(x[k] == Approx(limited).margin(1e-8));
  }
}

TEST_CASE("friction that changes its sign with the velocity is followed to its closed form") {
  const table::Table run = run_text(R"(events: locate
step: 10 ms
stop: 2 s
solver: rk4
blocks:
  v: {block: Integrator, u: a, initial: 1.2345}
  a: {block: Gain, gain: -3, u: side}
  side: {block: Compare, u: v, operator: greater, to: 0.5}
record: [v]
)");
  // v falls by 3/s until 0.5 and stays.
  const auto &time = column(run, "time"), &v = column(run, "v");
  for (std::size_t k = 0; k < v.size(); ++k)
    CHECK(v[k] == Approx(std::max(1.2345 - 3.0 * time[k], 0.5)).margin(1e-10));
}

TEST_CASE("events that follow each other ever faster end the run") {
  const RunResult result = result_of(R"(events: locate
step: 10 ms
stop: 1 s
solver: rk4
blocks:
  x: {block: Integrator, u: turn, initial: 0.1234}
  turn: {block: Relay, switch_on: 0, switch_off: 0, when_on: -1, when_off: 1, u: x}
record: [x]
)");
  REQUIRE(result.faults.size() == 1);
  CHECK_THAT(
      result.faults[0].fault.text(),
      Catch::Contains("turn: more than 50 events in the step to 0.13 s") && Catch::Contains("hysteresis"));
}

TEST_CASE("a run that goes back to a moment locates its events at the same bits") {
  const plan::Plan plan = plan_text(ball("events: locate\nsolver: rk4\n"));
  Executor run(plan);
  const auto go = [&] {
    for (int tick = 0; tick < 700; ++tick) {
      run.evaluate();
      run.advance();
    }
    return run.workspace().values;
  };
  go();
  const Workspace moment = run.workspace();
  const std::vector<double> first = go();
  run.restore(moment);
  CHECK(go() == first);
}

TEST_CASE("blocks of a period of their own keep to their ticks where events are located") {
  const table::Table run = run_text(R"(events: locate
step: 10 ms
stop: 1 s
solver: rk4
blocks:
  x: {block: Integrator, u: 1, reset: full, trigger: level}
  full: {block: Compare, u: x.before, operator: greater_equal, to: 0.0731}
  count: {block: DiscreteIntegrator, u: 100, every: 10 ms}
  last: {block: UnitDelay, u: x}
record: [x, count, last]
)");
  const auto &time = column(run, "time"), &count = column(run, "count"), &last = column(run, "last"),
             &x = column(run, "x");
  for (std::size_t k = 1; k < x.size(); ++k) {
    CHECK(count[k] == Approx(100.0 * time[k]).margin(1e-9));
    CHECK(last[k] == x[k - 1]);
  }
}

}  // namespace stepwire::run

// Rows of the table of cases: what is right at an instant, and on both sides of it.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

const char* const all_solvers[] = {"euler",      "heun", "bogacki_shampine", "rk4", "dormand_prince",
                                   "rosenbrock", "sdirk"};
const char* const second_order[] = {"heun",           "bogacki_shampine", "rk4",
                                    "dormand_prince", "rosenbrock",       "sdirk"};

/// The number of a column in the row of a time.
double at(const table::Table& run, const std::string& name, double time) {
  const auto& times = column(run, "time");
  for (std::size_t k = 0; k < times.size(); ++k)
    if (std::abs(times[k] - time) < 1e-9) return column(run, name)[k];
  throw std::runtime_error("no row at that time");
}

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

table::Table falling(const std::string& solver, const std::string& block) {
  return run_text("step: 1 ms\nstop: 2.4 s\nsolver: " + solver + R"(
blocks:
  x: )" + block + R"(
  low: {block: Compare, u: x.before, operator: "<", to: 0.1}
  minus: {block: Gain, gain: -1, u: x}
  z: {block: Integrator, u: x}
record: [x, x.before, z]
)");
}

}  // namespace

TEST_CASE("a reset is seen by no stage of a solver") {
  for (const char* solver : second_order) {
    INFO(solver);
    const table::Table run = falling(solver, "{block: Integrator, u: minus, reset: low, initial: 1}");
    CHECK(at(run, "x.before", 2.303) == Approx(std::exp(-2.303)).epsilon(1e-6));
    CHECK(at(run, "x", 2.303) == 1.0);
    CHECK(at(run, "z", 2.303) == Approx(1.0 - std::exp(-2.303)).epsilon(1e-6));
    CHECK(at(run, "x", 2.304) == Approx(std::exp(-0.001)).epsilon(1e-9));
  }
}

TEST_CASE("a lag and a transfer function are reset as an integrator is") {
  // x' = -x from 1, back to 1 where it has fallen to 0.1: the same as the integrator of -x.
  const char* const model = R"(step: 1 ms
stop: 2.4 s
solver: rk4
blocks:
  lag: {block: Lag, u: 0, tau: 1 s, reset: low, initial: 1}
  system: {block: StateSpace, A: [[-1]], B: [[0]], C: [[1]], D: [[0]], u: 0, reset: low, initial: 1}
  low: {block: Compare, u: fall, operator: "<", to: 0.1}
  fall: {block: Lag, u: 0, tau: 1 s, initial: 1}
  z: {block: Integrator, u: lag}
  w: {block: Integrator, u: system}
record: [lag, z, w]
)";
  const table::Table run = run_text(model);
  CHECK(at(run, "z", 2.303) == Approx(1.0 - std::exp(-2.303)).epsilon(1e-9));
  CHECK(at(run, "w", 2.303) == Approx(1.0 - std::exp(-2.303)).epsilon(1e-9));
  CHECK(at(run, "lag", 2.303) == 1.0);
}

TEST_CASE("a reset by a formula is located as one by Compare is") {
  for (const char* low :
       {R"({block: Compare, u: x.before, operator: "<", to: 0.1})",
        R"({block: Expression, u: [x.before], expression: "u < 0.1"})",
        R"({block: Expression, u: [x.before], expression: "u < 0.1 ? 2 : -2"})",
        R"({block: Expression, u: [x.before], expression: "1 - !(u < 0.1) > 0.5 && u < 3"})"}) {
    INFO(low);
    const table::Table run =
        run_text(std::string("events: locate\nstep: 0.1 s\nstop: 2.4 s\nsolver: dormand_prince\n") +
                 R"(blocks:
  x: {block: Integrator, u: minus, reset: low, initial: 1}
  minus: {block: Gain, gain: -1, u: x}
  low: )" + low + "\nrecord: [x]\n");
    // From ln 10 on it falls from 1 again.
    CHECK(last(run, "x") == Approx(std::exp(std::log(10.0) - 2.4)).epsilon(1e-8));
  }
}

TEST_CASE("an edge between two ticks is found once, and the next tick shows it") {
  const table::Table run = run_text(R"(events: locate
step: 0.1 s
stop: 1 s
solver: rk4
blocks:
  x: {block: Integrator, u: 1}
  high: {block: Compare, u: x, operator: ">", to: 0.55}
  edge: {block: EdgeDetect, u: high}
  count: {block: Counter, u: edge}
  sampled: {block: SampleAndHold, u: x, when: high}
  kept: {block: Latch, set: edge, reset: never}
  never: {block: Constant, value: 0}
  since: {block: Integrator, u: kept}
record: [edge, count, sampled, since]
)");
  CHECK(last(run, "count") == 1.0);
  double recorded = 0.0;
  for (const double edge : column(run, "edge")) recorded += edge;
  CHECK(recorded == 1.0);
  CHECK(at(run, "edge", 0.6) == 1.0);
  CHECK(last(run, "sampled") == Approx(0.55).epsilon(1e-11));
  CHECK(last(run, "since") == Approx(0.45).epsilon(1e-11));
}

TEST_CASE("edges and corners of sources between ticks are instants where events are located") {
  for (const char* solver : all_solvers) {
    INFO(solver);
    const bool first_order = std::string(solver) == "euler";
    const table::Table run =
        run_text(std::string("events: locate\nstep: 0.1 s\nstop: 1 s\nsolver: ") + solver + R"(
blocks:
  step: {block: Step, time: 0.53 s}
  pulse: {block: Pulse, period: 0.25 s, width: 0.3, delay: 0.07 s}
  ramp: {block: Ramp, start: 0.33 s}
  steps: {block: Integrator, u: step}
  pulses: {block: Integrator, u: pulse}
  ramps: {block: Integrator, u: ramp}
record: [steps, pulses, ramps]
)");
    CHECK(last(run, "steps") == Approx(0.47).epsilon(1e-12));
    CHECK(last(run, "pulses") == Approx(0.3).epsilon(1e-12));
    if (!first_order) CHECK(last(run, "ramps") == Approx(0.5 * 0.67 * 0.67).epsilon(1e-12));
  }
}

TEST_CASE("edges of a source, and what they make cross, are found in one step") {
  // The pulse is high from 0.1 to 0.2 and from 0.4 to 0.5; its integral passes 0.15 at 0.45, within the
  // second.
  const table::Table run = run_text(R"(events: locate
step: 1 s
stop: 1 s
solver: rk4
blocks:
  pulse: {block: Pulse, period: 0.3 s, width: 0.1 s/0.3 s, delay: 0.1 s}
  sum: {block: Integrator, u: pulse}
  high: {block: Compare, u: sum, operator: ">", to: 0.15}
  since: {block: Integrator, u: high}
record: [sum, since]
)");
  CHECK(last(run, "sum") == Approx(0.3).epsilon(1e-11));
  CHECK(last(run, "since") == Approx(0.55).epsilon(1e-11));
}

namespace {

/// The error of a closed loop of a plant 0.5 / (2 s + 1) and a gain of 50 that a step drives, which begins at
/// a tick.
double loop_error(const std::string& solver, const std::string& source, double step) {
  const table::Table run = run_text("step: " + std::to_string(step) + " s\nstop: 1.5 s\nsolver: " + solver +
                                    R"(
blocks:
  now: {block: Clock}
  command: )" + source + R"(
  error: {block: Sum, u: [command, plant], signs: "+-"}
  gain: {block: Gain, gain: 50, u: error}
  plant: {block: Lag, u: gain, tau: 2 s, gain: 0.5}
record: [plant]
)");
  double worst = 0.0;
  const auto &time = column(run, "time"), &y = column(run, "plant");
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double right = time[k] < 1.0 ? 0.0 : 25.0 / 26.0 * (1.0 - std::exp(-13.0 * (time[k] - 1.0)));
    worst = std::max(worst, std::abs(y[k] - right));
  }
  return worst;
}

}  // namespace

TEST_CASE("behind an edge of a source on a tick the error has the solver's order") {
  const std::pair<const char*, double> orders[] = {{"heun", 2.0},       {"bogacki_shampine", 3.0},
                                                   {"rk4", 4.0},        {"dormand_prince", 5.0},
                                                   {"rosenbrock", 2.0}, {"sdirk", 3.0}};
  for (const char* source :
       {"{block: Step, time: 1 s}", R"({block: Compare, u: now, operator: ">=", to: 1 s})",
        R"({block: Expression, u: [now], expression: "u >= 1 s"})",
        R"({block: Pulse, period: 4 s, delay: 1 s})"})
    for (const auto& [solver, order] : orders) {
      INFO(solver << " " << source);
      const double coarse = loop_error(solver, source, 0.02), fine = loop_error(solver, source, 0.01);
      CHECK(std::log2(coarse / fine) > order - 0.5);
      CHECK(coarse < 0.02);
    }
}

TEST_CASE("two crossings in one step are found") {
  // x = sin(2 pi t) is above 0.99 for acos(0.99)/pi = 45 ms in the middle of each second, and steps are 50 ms
  // long.
  const double above = std::acos(0.99) / 3.14159265358979323846;
  for (const char* head : {"step: 50 ms\nsolver: rk4\n", "step: 50 ms\nsolver: dormand_prince\n"}) {
    INFO(head);
    const table::Table run = run_text(std::string("events: locate\nstop: 3 s\n") + head + R"(
blocks:
  a: {block: Gain, gain: -39.47841760435743, u: x}
  v: {block: Integrator, u: a, initial: 6.283185307179586}
  x: {block: Integrator, u: v}
  high: {block: Compare, u: x, operator: ">", to: 0.99}
  since: {block: Integrator, u: high}
  edge: {block: EdgeDetect, u: high}
  count: {block: Counter, u: edge}
record: [since, count]
)");
    CHECK(last(run, "count") == 3.0);
    CHECK(last(run, "since") == Approx(3.0 * above).epsilon(5e-2));
  }
}

namespace {

std::string ball(const std::string& restitution, const std::string& step, const std::string& stop) {
  return "events: {max_per_step: 1000}\nsolver: rk4\nstep: " + step + "\nstop: " + stop + R"(
blocks:
  v: {block: Integrator, u: -9.81, reset: hit, value: bounce}
  x: {block: Integrator, u: v, initial: 1}
  hit: {block: Compare, u: x, operator: less, to: 0}
  bounce: {block: Gain, gain: -)" +
         restitution + R"(, u: v.before}
record: [x, v]
)";
}

}  // namespace

TEST_CASE("a ball that comes to rest falls through no floor: its run ends where its bounces do") {
  for (const double restitution : {0.5, 0.8, 0.9})
    for (const char* step : {"1 ms", "12.5 ms", "0.1 ms"}) {
      INFO(restitution << " " << step);
      const plan::Plan plan = plan_text(ball(std::to_string(restitution), step, "20 s"));
      Executor run(plan);
      double lowest = 0.0;
      while (!run.finished() && run.healthy()) {
        run.evaluate();
        lowest = std::min(lowest, run.values()[plan.slot(plan.diagram.records[0].signals[0].signal).offset]);
        if (run.healthy()) run.advance();
      }
      REQUIRE_FALSE(run.healthy());
      const double fall = std::sqrt(2.0 / 9.81);
      CHECK(run.fault()->time == Approx(fall * (1.0 + restitution) / (1.0 - restitution)).epsilon(1e-6));
      CHECK(run.fault()->fault.text().find("ever faster") != std::string::npos);
      CHECK(lowest > -1e-9);
    }
}

TEST_CASE("blocks that keep changing each other at one instant end the run with their names") {
  const plan::Plan plan = plan_text(R"(events: {rounds: 20}
step: 0.1 s
stop: 1 s
solver: rk4
blocks:
  x: {block: Integrator, u: 1}
  high: {block: Compare, u: x, operator: ">", to: 0.55}
  flips: {block: Integrator, u: 0, reset: high, trigger: level, value: other}
  other: {block: Expression, u: [flips.before], expression: "1 - u"}
)");
  Executor run(plan);
  while (!run.finished() && run.healthy()) {
    run.evaluate();
    if (run.healthy()) run.advance();
  }
  REQUIRE_FALSE(run.healthy());
  CHECK(run.fault()->time == Approx(0.55));
  const std::string text = run.fault()->fault.text();
  CHECK_THAT(text, Catch::Contains("keep changing each other") && Catch::Contains("20 rounds"));
}

}  // namespace stepwire::run

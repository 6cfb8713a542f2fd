#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

const std::string fall = R"(step: 10 ms
stop: 4 s
solver: rk4
blocks:
  v: {block: Integrator, u: -9.81}
  x: {block: Integrator, u: v, initial: 1}
record: [x, v]
)";

double last(const table::Table& run, const std::string& name) {
  return column(run, name).back();
}

std::string text(const std::string& blocks, const std::string& record, const std::string& head = "") {
  return "events: locate\nstep: 10 ms\nstop: 1 s\nsolver: rk4\n" + head + "blocks:\n" + blocks +
         "record: " + record + "\n";
}

/// Time of the sine's passing through a level, with that period, the n-th time; rising with even n.
double passing(double level, double period, int n) {
  const double first = std::asin(level) / (2.0 * std::numbers::pi) * period;
  return n % 2 == 0 ? first + n / 2 * period : 0.5 * period - first + (n - 1) / 2 * period;
}

}  // namespace

TEST_CASE("a reset is located in every block whose states the solver moves") {
  // The signal is a parabola that becomes true at 0.43217 s, in the middle of a step.
  const double at = 0.43217;
  const std::string signal =
      "  t: {block: Clock}\n  r: {block: Expression, u: t, expression: u^2 - 0.43217^2}\n";
  const auto end = [&](const std::string& block) {
    return last(run_text(text(signal + "  y: {block: " + block + ", reset: r}\n", "[y]")), "y");
  };
  const double since = 1.0 - at;
  CHECK(end("Integrator, u: 2, initial: 5") == Approx(5.0 + 2.0 * since).epsilon(1e-11));
  CHECK(end("Lag, u: 3, tau: 0.4, initial: 1") == Approx(3.0 - 2.0 * std::exp(-since / 0.4)).epsilon(1e-9));
  const double second = 1.0 - std::exp(-since) * (1.0 + since);  // 1/(s + 1)^2
  CHECK(end("TransferFunction, u: 1, denominator: [1, 2, 1]") == Approx(second).epsilon(1e-9));
  CHECK(end("StateSpace, u: 1, A: [[-2, -1], [1, 0]], B: [1, 0], C: [[0, 1]]") ==
        Approx(second).epsilon(1e-9));
  CHECK(end("PID, u: 0.5, kp: 2, ki: 3") == Approx(1.0 + 1.5 * since).epsilon(1e-11));
  CHECK(end("Derivative, u: 3, tau: 0.2, initial: 0") == Approx(15.0 * std::exp(-since / 0.2)).epsilon(1e-6));
  CHECK(end("LuenbergerObserver, measured: 1, A: [[0]], C: [[1]], L: [[2]]") ==
        Approx(1.0 - std::exp(-2.0 * since)).epsilon(1e-9));
}

TEST_CASE("a level holds a lag from the instant at which it becomes true to that at which it ends") {
  const table::Table run =
      run_text(text("  r: {block: Sine, frequency: 1 Hz, bias: 0.123}\n"
                    "  y: {block: Lag, u: 1, tau: 0.5, reset: r, trigger: level}\n",
                    "[y]"));
  const double ends = 0.5 + std::asin(0.123) / (2.0 * std::numbers::pi);
  const double begins = 1.0 - (ends - 0.5);
  CHECK(last(run, "y") == 0.0);
  const auto &time = column(run, "time"), &y = column(run, "y");
  for (std::size_t k = 0; k < y.size(); ++k) {
    const bool free = time[k] > ends && time[k] < begins;
    CHECK(y[k] == Approx(free ? 1.0 - std::exp(-(time[k] - ends) / 0.5) : 0.0).margin(1e-8));
  }
}

TEST_CASE("a controller takes over at the instant at which it is switched on") {
  const table::Table run =
      run_text(text("  t: {block: Clock}\n  on: {block: Sum, signs: \"+-\", u: [t, 0.43217]}\n"
                    "  y: {block: PID, u: 1, kp: 1, ki: 4, manual: 2, automatic: on}\n",
                    "[y]"));
  // The manual output is 2; after the switch it rises from there by 4 in each second.
  CHECK(last(run, "y") == Approx(2.0 + 4.0 * (1.0 - 0.43217)).epsilon(1e-11));
}

TEST_CASE(
    "play that is pushed to and fro keeps to its closed form, and no rounding of its ends is an event") {
  for (const char* const step : {"5 ms", "1 ms", "0.2 ms"}) {
    INFO(step);
    const table::Table run =
        run_text(std::string("events: locate\nsolver: rk4\nstop: 2 s\nstep: ") + step + R"(
blocks:
  u: {block: Sine, frequency: 2.3 Hz, phase: 1}
  y: {block: Backlash, u: u, width: 0.3}
record: [u, y]
)");
    const auto &time = column(run, "time"), &u = column(run, "u"), &y = column(run, "y");
    // Between two turns of the input it is where it was at the first, unless an end of the gap pushes it. A
    // turn is up to half a step from the nearest tick, which misses so much of a peak.
    const double way = 2.0 * std::numbers::pi * 2.3 * 0.5 * time[1], missed = 0.5 * way * way;
    double held = std::clamp(0.0, u[0] - 0.15, u[0] + 0.15);
    int turn = 0;
    for (std::size_t k = 0; k < y.size(); ++k) {
      for (; (turn + 0.5) * std::numbers::pi < 2.0 * std::numbers::pi * 2.3 * time[k] + 1.0; ++turn) {
        const double end = turn % 2 == 0 ? 1.0 : -1.0;
        held = std::clamp(held, end - 0.15, end + 0.15);
      }
      CHECK(y[k] == Approx(std::clamp(held, u[k] - 0.15, u[k] + 0.15)).margin(missed));
    }
  }
}

TEST_CASE("a run ends where its stop condition becomes true, and its last row is there") {
  const table::Table run = run_text("events: locate\nstop_when: x < 0\n" + fall);
  const double end = std::sqrt(2.0 / 9.81);
  CHECK(last(run, "time") == Approx(end).epsilon(1e-12));
  CHECK(last(run, "x") == Approx(0.0).margin(1e-12));
  CHECK(last(run, "v") == Approx(-9.81 * end).epsilon(1e-12));
  CHECK(column(run, "time").size() == static_cast<std::size_t>(end / 0.01) + 2);
  CHECK(last(run_text("stop_when: x < 0\n" + fall), "time") == Approx(0.46).epsilon(1e-12));
}

TEST_CASE("only what makes a condition true ends a run, of all that is compared in it") {
  // x < 0.5 from 0.31928 s on; v < -4 from 0.40775 s on.
  const auto end = [](const std::string& condition) {
    return last(run_text("events: locate\nstop_when: '" + condition + "'\n" + fall), "time");
  };
  CHECK(end("x < 0.5 && v < -4") == Approx(4.0 / 9.81).epsilon(1e-12));
  CHECK(end("x < 0.5 || v < -4") == Approx(std::sqrt(1.0 / 9.81)).epsilon(1e-12));
  CHECK(end("!(x >= 0.5)") == Approx(std::sqrt(1.0 / 9.81)).epsilon(1e-12));
  CHECK(end("time > 0.12345") == Approx(0.12345).epsilon(1e-12));
  CHECK(end("x > 2") == 4.0);
}

TEST_CASE("a stop condition that holds at the beginning, or at a tick, ends the run there") {
  CHECK(last(run_text("events: locate\nstop_when: x < 2\n" + fall), "time") == 0.0);
  CHECK(last(run_text("events: locate\nstop_when: time >= 0.25\n" + fall), "time") ==
        Approx(0.25).epsilon(1e-12));
}

TEST_CASE("a part integrates from where its condition becomes true to where it ceases to be") {
  const table::Table run =
      run_text(text("  x: {block: Integrator, u: 1, enable: time > 0.12345 && time <= 0.6789}\n", "[x]"));
  const auto &time = column(run, "time"), &x = column(run, "x");
  for (std::size_t k = 0; k < x.size(); ++k)
    CHECK(x[k] == Approx(std::clamp(time[k], 0.12345, 0.6789) - 0.12345).margin(1e-12));
}

TEST_CASE("a signal that enables is located where it passes 0") {
  const std::string blocks =
      "  s: {block: Sine, frequency: 3 Hz}\n  level: {block: Sum, u: [s, -0.6]}\n"
      "  x: {block: Integrator, u: 1, enable: level}\n";
  double expected = 0.0;
  for (int n = 0; n < 6; n += 2) expected += passing(0.6, 1.0 / 3.0, n + 1) - passing(0.6, 1.0 / 3.0, n);
  CHECK(last(run_text(text(blocks, "[x]")), "x") == Approx(expected).epsilon(1e-11));
  std::string unlocated = text(blocks, "[x]");
  unlocated.erase(0, unlocated.find('\n') + 1);
  CHECK(std::abs(last(run_text(unlocated), "x") - expected) > 1e-4);
}

TEST_CASE("states begin anew, and outputs are held, at the instant itself") {
  const table::Table run = run_text(text(R"(  s: {block: Sine, frequency: 3 Hz}
  t: {block: Integrator, u: 1}
  x: {block: Integrator, u: 1, initial: 0.5, enable: {when: s > 0.6, states: reset}}
  twice: {block: Gain, gain: 2, u: t, enable: s > 0.6}
)",
                                         "[x, twice]"));
  const auto &time = column(run, "time"), &x = column(run, "x"), &twice = column(run, "twice");
  for (std::size_t k = 0; k < x.size(); ++k)
    for (int n = 0; n < 6; n += 2) {
      const double on = passing(0.6, 1.0 / 3.0, n), off = passing(0.6, 1.0 / 3.0, n + 1);
      if (time[k] < on || time[k] > on + 1.0 / 3.0) continue;
      CHECK(x[k] == Approx(0.5 + std::min(time[k], off) - on).epsilon(1e-10));
      CHECK(twice[k] == Approx(2.0 * std::min(time[k], off)).epsilon(1e-10));
    }
}

TEST_CASE("what is triggered runs at the edge itself, and once for each") {
  const table::Table run = run_text(text(R"(  s: {block: Sine, frequency: 3 Hz}
  t: {block: Integrator, u: 1}
  at: {block: Gain, gain: 1, u: t, trigger: s > 0.6}
  next: {block: Sum, u: [count, 1], trigger: s > 0.6}
  count: {block: UnitDelay, u: next, trigger: {when: s > 0.6}}
)",
                                         "[at, next]"));
  const auto &time = column(run, "time"), &at = column(run, "at"), &count = column(run, "next");
  for (std::size_t k = 0; k < at.size(); ++k) {
    int edges = 0;
    while (passing(0.6, 1.0 / 3.0, 2 * edges) < time[k]) ++edges;
    CHECK(count[k] == edges);
    if (edges > 0) CHECK(at[k] == Approx(passing(0.6, 1.0 / 3.0, 2 * (edges - 1))).epsilon(1e-11));
  }
}

TEST_CASE("what has no continuous states is located, too") {
  const table::Table run = run_text(
      "events: locate\nstep: 10 ms\nstop: 1 s\nstop_when: s > 0.6\nblocks:\n"
      "  s: {block: Sine, frequency: 3 Hz}\n  high: {block: Compare, u: s, operator: greater, to: 0.3}\n"
      "record: [s, high]\n");
  CHECK(last(run, "time") == Approx(passing(0.6, 1.0 / 3.0, 0)).epsilon(1e-11));
  CHECK(last(run, "high") == 1.0);
}

TEST_CASE("conditions with a period of their own keep to their ticks") {
  const table::Table run =
      run_text(text("  t: {block: Integrator, u: 1}\n"
                    "  at: {block: Gain, gain: 1, u: t, every: 50 ms, trigger: t > 0.123}\n",
                    "[at]"));
  CHECK(last(run, "at") == Approx(0.15).epsilon(1e-12));
}

TEST_CASE("compiled code locates conditions to the same bits") {
  codegen::GeneratedCode source{run::code_trial()};
  const std::string conditions = text(R"(  s: {block: Sine, frequency: 3 Hz}
  t: {block: Integrator, u: 1}
  x: {block: Integrator, u: s, initial: 0.5, enable: {when: s > 0.6, states: reset, outputs: reset}}
  at: {block: Gain, gain: 1, u: t, trigger: {when: s > 0.2, edge: either}}
  low: {block: Lag, tau: 30 ms, u: at, enable: s}
)",
                                      "[x, at, low]", "stop_when: t > 0.91234 && s < 0\n");
  for (const char* solver : {"rk4", "sdirk"}) {
    std::string yaml = conditions;
    yaml.replace(yaml.find("rk4"), 3, solver);
    const plan::Plan plan = plan_text(yaml);
    const auto code = source.compile(plan, {}, {});
    INFO(source.take_problem());
    REQUIRE(code);
    Executor one(plan), other(plan);
    other.use(*code);
    while (!one.finished()) {
      one.evaluate();
      other.evaluate();
      for (std::size_t i = plan.layout.signals; i < plan.layout.derivatives; ++i)
        REQUIRE(one.values()[i] == other.values()[i]);
      one.advance();
      other.advance();
    }
    CHECK(one.time() == other.time());
    CHECK(one.time() < 1.0);
  }
}

TEST_CASE("compiled code follows a condition to its turn, to the same bits") {
  // x exceeds the threshold for 0.6 ms about each maximum, between two looks into a step of 7 ms.
  for (const std::string solver : {"dormand_prince", "{name: dop853, relative: 1e-11, absolute: 1e-12}"}) {
    const plan::Plan plan = plan_text("solver: " + solver + R"(
events: locate
step: 7 ms
stop: 4.9 s
blocks:
  v: {block: Integrator, u: a, initial: 6.283185307179586 1/s}
  a: {block: Gain, u: x, gain: -39.47841760435743 1/s^2}
  x: {block: Integrator, u: v}
  c: {block: Compare, u: x, operator: '>', to: 0.9999982234720354}
  n: {block: Counter, u: c}
record: [n]
)");
    codegen::GeneratedCode source{run::code_trial()};
    const auto code = source.compile(plan, {}, {});
    INFO(source.take_problem());
    REQUIRE(code);
    Executor one(plan), other(plan);
    other.use(*code);
    bool same = true;
    for (; !one.finished(); one.advance(), other.advance()) {
      one.evaluate();
      other.evaluate();
      for (std::size_t i = plan.layout.signals; i < plan.layout.derivatives; ++i)
        same = same && one.values()[i] == other.values()[i];
    }
    one.evaluate();
    CHECK(same);
    CHECK(one.values()[plan.slot(plan.diagram.records.front().signals.front().signal).offset] == 5.0);
  }
}

TEST_CASE(
    "a period within what is triggered at located edges is refused, and one of what is triggered is not") {
  const DiagramFolder folder;
  folder.write("part.yaml", R"(stepwire: 1
title: counts tenths of a second
blocks:
  m: {block: DiscreteIntegrator, u: 1, every: 0.1 s}
outputs: {y: m}
)");
  const auto whole = [](const std::string& events, const std::string& keys) {
    return "stepwire: 1\ntitle: t\nstep: 0.1 s\nstop: 4 s\n" + events + R"(blocks:
  pulse: {block: Pulse, period: 0.37 s, width: 30 %, delay: 0.111 s}
  p: {diagram: part.yaml, trigger: pulse > 0.5)" +
           keys + "}\nrecord: [p.y]\n";
  };
  folder.write("ticks.yaml", whole("", ""));
  CHECK(column(folder.run("ticks.yaml"), "p.y").back() == Approx(1.0));
  folder.write("located.yaml", whole("events: locate\n", ""));
  const std::vector<std::string> faults = folder.faults("located.yaml");
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0], Catch::Contains("p.m.every: edges of its trigger are located between ticks"));
  folder.write("period.yaml", whole("events: locate\n", ", every: 0.1 s"));
  CHECK(column(folder.run("period.yaml"), "p.y").back() == Approx(1.0));
}

}  // namespace stepwire::run

// Values just before an instant: those of the branch that held until then.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

double last(const std::string& yaml, const std::string& name) {
  return column(result_of(yaml).recordings.front().table, name).back();
}

/// Blocks that jump from 0 to 1 where `w` exceeds a threshold.
constexpr const char* jumps[] = {
    "{{block: Switch, control: w, threshold: {}, then: 1, else: 0}}",
    "{{block: Compare, u: w, operator: greater, to: {}}}",
    "{{block: Expression, u: w, expression: \"u > {} ? 1 + 0*u : 0\"}}",
};

constexpr double thresholds[] = {0.05, 0.062, 0.126, 0.25, 0.401};

}  // namespace

TEST_CASE("a delay carries the jump of a branch as a jump") {
  // The sine of 0.1 Hz exceeds h at asin(h)/(0.2 pi), and the delay is 0.2137 s.
  for (const char* jump : jumps)
    for (const char* step : {"200 ms", "10 ms", "1 ms"})
      for (const double threshold : thresholds) {
        const double right = 1.0 - std::asin(threshold) / (0.2 * std::numbers::pi) - 0.2137;
        const std::string block = fmt::format(fmt::runtime(jump), threshold);
        INFO(block << " at " << step);
        const std::string yaml = fmt::format(
            "step: {}\nstop: 1 s\nsolver: rk4\nevents: locate\nblocks:\n"
            "  w: {{block: Sine, frequency: 0.1 Hz}}\n  y: {}\n"
            "  z: {{block: TransportDelay, u: y, delay: 0.2137 s}}\n  j: {{block: Integrator, u: z}}\n"
            "record: [j]\n",
            step, block);
        CHECK(last(yaml, "j") == Approx(right).margin(1e-9));
      }
}

TEST_CASE("a jump through a delay that changes is a jump for the next delay") {
  // The step at 0.123 s arrives where t = 0.123 + 0.9 - 0.2 t, that is at 0.8525 s.
  for (const char* step : {"100 ms", "50 ms", "10 ms", "1 ms"}) {
    INFO(step);
    const std::string yaml = fmt::format(
        "step: {}\nstop: 2 s\nsolver: rk4\nevents: locate\nblocks:\n  u: {{block: Step, time: 0.123 s}}\n"
        "  d: {{block: Ramp, slope: -0.2 s/s, initial: 0.9 s}}\n"
        "  y: {{block: TransportDelay, u: u, delay: d}}\n"
        "  z: {{block: TransportDelay, u: y, delay: 0.2137 s}}\n  j: {{block: Integrator, u: z}}\nrecord: "
        "[j]\n",
        step);
    CHECK(last(yaml, "j") == Approx(2.0 - 0.8525 - 0.2137).margin(1e-9));
  }
}

TEST_CASE("rows on both sides of a located jump have its two values") {
  for (const char* jump : jumps) {
    const std::string block = fmt::format(fmt::runtime(jump), 0.352);
    INFO(block);
    const auto table = result_of(
                           "step: 100 ms\nstop: 0.6 s\nsolver: rk4\nevents: locate\nblocks:\n"
                           "  w: {block: Integrator, u: 1}\n  y: " +
                           block + "\nrecord: {instants: true, signals: [y]}\n")
                           .recordings.front()
                           .table;
    const auto time = column(table, "time"), y = column(table, "y");
    int rows = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
      if (std::abs(time[i] - 0.352) > 1e-9) continue;
      CHECK(y[i] == (rows == 0 ? 0.0 : 1.0));
      ++rows;
    }
    CHECK(rows == 2);
  }
}

TEST_CASE("a branch that turns at a tick leaves the step before it alone") {
  // After a step is at the tick of the threshold, the integral of the branch is 1 s less the threshold, or a
  // step less where rounding delays the branch by a tick.
  for (const char* block : {"{{block: Switch, control: w, threshold: {}, then: 1, else: 0}}",
                            "{{block: Expression, u: w, expression: \"u > {} ? 1 + 0*u : 0\"}}",
                            "{{block: Quantizer, u: half, interval: 1}}"})
    for (const char* solver : {"rk4", "dormand_prince", "heun"})
      for (const double threshold : {0.1, 0.11, 0.12, 0.13, 0.3}) {
        INFO(block << " " << solver << " " << threshold);
        const std::string yaml = fmt::format(
            "step: 10 ms\nstop: 1 s\nsolver: {}\nevents: locate\nblocks:\n  w: {{block: Integrator, u: 1}}\n"
            "  half: {{block: Gain, u: w, gain: {}}}\n  y: {}\n  I: {{block: Integrator, u: y}}\n"
            "record: [I]\n",
            solver, 0.5 / threshold, fmt::format(fmt::runtime(block), threshold));
        const bool steps = std::string(block).find("Quantizer") != std::string::npos;
        double right = 1.0 - threshold;
        for (double level = 3.0 * threshold; steps && level < 1.0; level += 2.0 * threshold)
          right += 1.0 - level;
        CHECK(last(yaml, "I") == Approx(right).margin(1e-12));
      }
}

TEST_CASE("dry friction turns where the speed passes 0") {
  // A push of -5 N against 2 N of friction and 1 kg: -7 m/s2 from 3 m/s until 3/7 s, then -3 m/s2.
  const double turn = 3.0 / 7.0, left = 1.0 - turn;
  for (const char* solver : {"rk4", "dormand_prince", "heun"}) {
    INFO(solver);
    const std::string yaml = fmt::format(
        "step: 50 ms\nstop: 1 s\nsolver: {}\nevents: locate\nblocks:\n"
        "  f: {{block: Coulomb, u: v, coulomb: 2}}\n"
        "  a: {{block: Sum, signs: \"--\", u: [f, 5]}}\n"
        "  v: {{block: Integrator, u: a, initial: 3}}\n  x: {{block: Integrator, u: v}}\n"
        "record: [v, x]\n",
        solver);
    CHECK(last(yaml, "v") == Approx(-3.0 * left).margin(1e-12));
    CHECK(last(yaml, "x") == Approx(1.5 * turn - 1.5 * left * left).margin(1e-12));
  }
}

TEST_CASE("a switch passes a signal on within the steps of a solver") {
  // Behind a switch that passes on the first lag, the second one has the bits that it has without a switch.
  for (const char* events : {"tick", "locate"}) {
    INFO(events);
    const std::string yaml = fmt::format(
        "step: 1 ms\nstop: 5 ms\nsolver: rk4\nevents: {}\nblocks:\n"
        "  u: {{block: Step, time: 0 s}}\n  a: {{block: Lag, tau: 0.6 ms, u: u}}\n"
        "  s: {{block: Switch, control: 1, then: a, else: 0}}\n"
        "  b: {{block: Lag, tau: 5 ms, u: s}}\n  c: {{block: Lag, tau: 5 ms, u: a}}\n"
        "record: [b, c]\n",
        events);
    const double right = 1.0 - (5.0 * std::exp(-1.0) - 0.6 * std::exp(-5.0 / 0.6)) / (5.0 - 0.6);
    CHECK(last(yaml, "b") == last(yaml, "c"));
    CHECK(last(yaml, "b") == Approx(right).epsilon(0.03));
  }
}

TEST_CASE("a formula that jumps and slows what it drives turns at the instant of its condition") {
  // From 1 at -3 1/s until 0.3, then at a slower rate.
  for (const char* solver : {"rk4", "heun", "dormand_prince", "{name: dop853, relative: 1e-9}", "sdirk"})
    for (const double slow : {-0.01, -0.5, -1.4, -2.9, -30.0})
      for (const char* formula :
           {"u > 0.3 ? -3 : {0} + 0*u", "(u <= 0.3 ? {0} : -3) + 0*u", "-3 + ({0} + 3)*(u < 0.3) + 0*u",
            "({0} - 3)/2 - ({0} + 3)/2*sign(u - 0.3) + 0*u"}) {
        const std::string rate = fmt::format(fmt::runtime(formula), slow);
        INFO(solver << " " << rate);
        const std::string yaml = fmt::format(
            "step: 10 ms\nstop: 0.31 s\nsolver: {}\nevents: locate\nblocks:\n"
            "  r: {{block: Expression, u: x, expression: \"{}\"}}\n"
            "  x: {{block: Integrator, u: r, initial: 1}}\nrecord: [x]\n",
            solver, rate);
        CHECK(last(yaml, "x") == Approx(0.3 + slow * (0.31 - 0.7 / 3.0)).margin(1e-11));
      }
}

TEST_CASE("a condition on a fast ramp is one event, late in a run and beside a source with edges, too") {
  // 1000.5 t - 1000 t - 50 is positive from 100 s on.
  for (const char* criterion : {"greater", "greater_equal"}) {
    const auto result = result_of(
        "step: 10 ms\nstop: 101 s\nsolver: rk4\nevents: locate\nblocks:\n"
        "  p: {block: Pulse, period: 10 s}\n  s: {block: Ramp, slope: 1000 1/s}\n"
        "  x: {block: Integrator, u: 1000.5}\n  d: {block: Sum, signs: \"+--\", u: [x, s, 50]}\n"
        "  w: {block: Switch, control: d, then: 1, else: 0, criterion: " +
        std::string(criterion) + "}\n  sum: {block: Integrator, u: w}\nrecord: [sum]\n");
    CHECK(result.events.located == 1);
    CHECK(column(result.recordings.front().table, "sum").back() == Approx(1.0).margin(1e-7));
  }
}

}  // namespace stepwire::run

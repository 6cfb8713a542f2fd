// A level trigger: while it holds, states follow their target between instants, and a release begins there.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

/// A block with a state that follows 2 t up to a release at T. Its output at 1 s, and the integral of it
/// after the release, with `r` as the value there and `d` as the time since then.
struct HeldBlock {
  const char* text;
  double (*at_end)(double r, double d);
  double (*area)(double r, double d);
};

double rises(double r, double d) {
  return r + d;
}
double area_of_rise(double r, double d) {
  return r * d + 0.5 * d * d;
}
double decays(double r, double d) {
  return r * std::exp(-2.0 * d);
}
double area_of_decay(double r, double d) {
  return 0.5 * r * (1.0 - std::exp(-2.0 * d));
}

const HeldBlock held_blocks[] = {
    {"Integrator, u: 1", rises, area_of_rise},
    {"PID, u: 1, kp: 0, ki: 1, kd: 0", rises, area_of_rise},
    {"Lag, u: 0, tau: 0.5", decays, area_of_decay},
    {"TransferFunction, u: 0, numerator: 1, denominator: [1, 2]", decays, area_of_decay},
    {"StateSpace, u: 0, A: -2, B: 1, C: 1", decays, area_of_decay},
};

/// Signals that are true before T.
constexpr const char* triggers[] = {
    "  when: {{block: Step, time: {} s, before: 1, after: 0}}\n",
    "  t: {{block: Clock}}\n  when: {{block: Compare, u: t, operator: '<', to: {} s}}\n",
};

table::Table run_held(const HeldBlock& block, const char* trigger, const std::string& head, double T) {
  return run_text(head + "stop: 1 s\nsolver: rk4\nblocks:\n" + fmt::format(fmt::runtime(trigger), T) +
                  fmt::format("  two: {{block: Ramp, slope: 2}}\n"
                              "  y: {{block: {}, reset: when, trigger: level, value: two}}\n"
                              "  j: {{block: Integrator, u: y}}\nrecord: [y, j]\n",
                              block.text));
}

void require_release(const std::string& head, double T) {
  for (const HeldBlock& block : held_blocks)
    for (const char* trigger : triggers) {
      INFO(block.text << " with " << trigger);
      const table::Table table = run_held(block, trigger, head, T);
      const double d = 1.0 - T, r = 2.0 * T;
      CHECK(column(table, "y").back() == Approx(block.at_end(r, d)).margin(1e-7));
      CHECK(column(table, "j").back() == Approx(T * T + block.area(r, d)).margin(1e-7));
    }
}

}  // namespace

TEST_CASE("a held state follows its value, and is released between two ticks at the value there") {
  require_release("events: locate\nstep: 10 ms\n", 0.5503);
}

TEST_CASE("a held state is released on a tick at the value there, not at that of the tick before") {
  require_release("step: 10 ms\n", 0.625 - 0.005);
}

TEST_CASE("a held Derivative follows its input and begins at it") {
  // u = 2 t: y = 2 (1 - exp(-d / tau)) after the release.
  for (const char* trigger : triggers) {
    const std::string text = "events: locate\nstep: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n" +
                             fmt::format(fmt::runtime(trigger), 0.5503) +
                             "  two: {block: Ramp, slope: 2}\n"
                             "  y: {block: Derivative, u: two, tau: 0.5, reset: when, trigger: level}\n"
                             "record: [y]\n";
    CHECK(column(run_text(text), "y").back() == Approx(2.0 * (1.0 - std::exp(-0.4497 / 0.5))).margin(1e-7));
    CHECK(column(run_text(text), "y")[40] == 0.0);
  }
}

TEST_CASE("a Derivative that is held from the first instant begins at its value") {
  const table::Table run = run_text(
      "step: 10 ms\nstop: 0.1 s\nsolver: rk4\nblocks:\n  v: {block: Constant, value: 2}\n"
      "  y: {block: Derivative, u: 0, tau: 0.5, reset: 1, trigger: level, value: v}\nrecord: [y]\n");
  for (const double y : column(run, "y")) CHECK(y == -4.0);
}

TEST_CASE("SampleAndHold with a level trigger holds what it has just before a located release") {
  const auto held = [](const std::string& u) {
    return column(
               run_text("events: locate\nstep: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n"
                        "  t: {block: Clock}\n"
                        "  when: {block: Compare, u: t, operator: '<', to: 0.5503 s}\n"
                        "  not: {block: Compare, u: t, operator: '>=', to: 0.5503 s}\n" +
                        u + "  y: {block: SampleAndHold, u: x, when: when, trigger: level}\nrecord: [y]\n"),
               "y")
        .back();
  };
  CHECK(held("  x: {block: Ramp, slope: 1}\n") == Approx(0.5503).epsilon(1e-9));
  CHECK(held("  x: {block: Integrator, u: 1, reset: not}\n") == Approx(0.5503).epsilon(1e-9));
}

TEST_CASE("a Mass that a level trigger holds refuses a velocity that changes") {
  CHECK_THAT(error_of("step: 10 ms\nstop: 1 s\nblocks:\n  v: {block: Ramp, slope: 1 m/s^2}\n"
                      "  m: {block: Mass, mass: 1 kg, force: 0 N, reset: 1, trigger: level, value: v}\n"),
             Catch::Contains("m.trigger") && Catch::Contains("cannot follow a signal"));
}

}  // namespace stepwire::run

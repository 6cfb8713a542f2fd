// Numbers that pass 0 twice within one step.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

/// Returns how long (t - turn)^2 is below `depth` in steps of 100 ms up to 1 s [s].
double time_below(double turn, double depth, const char* solver) {
  const std::string yaml = fmt::format(
      "step: 100 ms\nstop: 1 s\nsolver: {}\nevents: locate\nblocks:\n  t: {{block: Clock}}\n"
      "  x: {{block: Expression, u: t, expression: \"(u - {} s)^2 - {} s^2\"}}\n"
      "  below: {{block: Compare, u: x, operator: '<', to: 0 s^2}}\n"
      "  sum: {{block: Integrator, u: below}}\nrecord: [sum]\n",
      solver, turn, depth);
  return column(run_text(yaml), "sum").back();
}

}  // namespace

TEST_CASE("a dip beyond 0 is found wherever it is in a step") {
  for (const char* solver : {"rk4", "dormand_prince", "{name: dop853, relative: 1e-9}"})
    for (int place = 1; place < 50; ++place) {
      const double turn = 0.3 + 0.002 * place;
      INFO(solver << " at " << turn);
      CHECK(time_below(turn, 5e-5, solver) == Approx(2.0 * std::sqrt(5e-5)).margin(1e-9));
    }
}

TEST_CASE("a dip in the middle of the first step is found") {
  CHECK(time_below(0.05, 1e-5, "rk4") == Approx(2.0 * std::sqrt(1e-5)).margin(1e-9));
}

TEST_CASE("a signal through a delay that swings ends no run by events of its own") {
  const auto result = result_of(
      "step: 10 ms\nstop: 12 s\nsolver: rk4\nevents: locate\nblocks:\n  u: {block: Sine, frequency: 0.5 Hz}\n"
      "  w: {block: Sine, frequency: 1.5 Hz, amplitude: 0.3 s, bias: 0.5 s}\n"
      "  y: {block: TransportDelay, u: u, delay: w, longest: 1 s}\n"
      "  sum: {block: Integrator, u: y}\nrecord: [sum]\n");
  CHECK(column(result.recordings.front().table, "time").back() == Approx(12.0));
}

}  // namespace stepwire::run

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

const std::pair<const char*, double> orders[] = {{"euler", 1.0},
                                                 {"heun", 2.0},
                                                 {"bogacki_shampine", 3.0},
                                                 {"rk4", 4.0},
                                                 {"dormand_prince", 5.0},
                                                 {"rosenbrock", 2.0},
                                                 {"sdirk", 3.0},
                                                 {"{name: rodas, relative: 1, absolute: 1}", 4.0}};

/// The order at which the error of x at the end falls from one step to half of it.
double order_of(const std::string& diagram, const std::string& solver, double step, double right) {
  const auto error = [&](double length) {
    const std::string head = "solver: " + solver + "\nstep: " + std::to_string(length) + " s\n";
    return std::abs(column(run_text(head + diagram + "record: [x]\n"), "x").back() - right);
  };
  return std::log2(error(step) / error(step / 2.0));
}

void require_order(const std::string& diagram, double step, double right) {
  for (const auto& [solver, order] : orders) {
    INFO(solver);
    const double found = order_of(diagram, solver, step, right);
    CHECK(found > order - 0.35);
  }
}

/// x' = -x^2 from 1 is 1 / (1 + t).
const std::string falling =
    "  square: {block: Expression, u: x, expression: -u^2}\n"
    "  x: {block: Integrator, u: square, initial: 1, reset: back}\n";

}  // namespace

TEST_CASE("behind a source that moves each solver has its order") {
  // x' = sin(w t) - x from 1, with 0.5 Hz.
  const double w = std::acos(-1.0), part = 1.0 / (1.0 + w * w), t = 2.0;
  require_order(
      "stop: 2 s\nblocks:\n  s: {block: Sine, frequency: 0.5 Hz}\n  d: {block: Sum, signs: +-, u: [s, x]}\n"
      "  x: {block: Integrator, u: d, initial: 1}\n",
      0.1, (1.0 + part * w) * std::exp(-t) + part * (std::sin(w * t) - w * std::cos(w * t)));
}

TEST_CASE("with a reset on a tick each solver keeps its order") {
  require_order("stop: 1 s\nblocks:\n  now: {block: Clock}\n" + falling +
                    "  back: {block: Compare, u: now, operator: '>=', to: 0.6 s}\n",
                0.1, 1.0 / 1.4);
}

TEST_CASE("with a reset at a located crossing each solver keeps its order") {
  // It falls to 0.6 at 2/3 s, and is at 1 / (1 + 1/3) at 1 s.
  require_order("events: locate\nstop: 1 s\nblocks:\n" + falling +
                    "  back: {block: Compare, u: x.before, operator: '<', to: 0.6}\n",
                0.1, 0.75);
}

TEST_CASE("with a sampled part each solver keeps its order") {
  // x' = u - x^2 with u = x / 2 held over 0.2 s: Riccati's equation, solved by tanh over each period.
  double right = 1.0;
  for (int sample = 0; sample < 5; ++sample) {
    const double root = std::sqrt(0.5 * right), tanh = std::tanh(0.2 * root);
    right = root * (right + root * tanh) / (root + right * tanh);
  }
  require_order(
      "stop: 1 s\nblocks:\n  held: {block: Gain, u: x, gain: 0.5, every: 0.2 s}\n"
      "  slope: {block: Expression, u: [held, x], expression: u1 - u2^2}\n"
      "  x: {block: Integrator, u: slope, initial: 1}\n",
      0.1, right);
}

TEST_CASE("with a sampled part that begins later each solver keeps its order") {
  // Nothing is held up to 0.1 s.
  double right = 1.0 / 1.1;
  for (int sample = 0; sample < 5; ++sample) {
    const double root = std::sqrt(0.5 * right), tanh = std::tanh((sample < 4 ? 0.2 : 0.1) * root);
    right = root * (right + root * tanh) / (root + right * tanh);
  }
  require_order(
      "stop: 1 s\nblocks:\n"
      "  held: {block: Gain, u: x, gain: 0.5, every: {period: 0.2 s, offset: 0.1 s}}\n"
      "  slope: {block: Expression, u: [held, x], expression: u1 - u2^2}\n"
      "  x: {block: Integrator, u: slope, initial: 1}\n",
      0.05, right);
}

}  // namespace stepwire::run

// Blocks that act at ticks, in runs whose events are located between ticks.
#include <catch2/catch.hpp>
#include <string>

#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

/// A square wave is located at each of its edges, and `held` integrates the output of the sampler.
std::string with(const std::string& sampler, const std::string& events) {
  return "step: 0.1 s\nstop: 1 s\nsolver: rk4\nevents: " + events + R"(
blocks:
  t: {block: Clock}
  zero: {block: Constant, value: 0}
  s: {block: Sine, frequency: 3.3 Hz}
  high: {block: Compare, u: s, operator: greater, to: 0.3}
  x: {block: Integrator, u: high}
  y: {block: )" +
         sampler + R"(}
  held: {block: Integrator, u: y}
record: [y, held]
)";
}

}  // namespace

TEST_CASE("a sampler without a period of its own samples at ticks alone") {
  for (const char* sampler : {"ZeroOrderHold, u: t", "UnitDelay, u: t", "UnitDelay, u: t, reset: zero",
                              "Delay, u: t, delay: 0.2 s", "DiscreteIntegrator, u: t",
                              "DiscreteIntegrator, u: t, reset: zero", "DiscretePID, u: t, kp: 1, ki: 2",
                              "MovingAverage, u: t, window: 0.3 s", "RateLimiter, u: high, rising: 2 1/s",
                              "DiscreteTransferFunction, u: t, numerator: [1], denominator: [1, -0.5]"})
    for (const char* enable : {"", ", enable: s > 0.3", ", enable: {when: s > 0.3, states: reset}"}) {
      INFO(sampler << enable);
      const table::Table ticks = run_text(with(std::string(sampler) + enable, "tick"));
      const table::Table located = run_text(with(std::string(sampler) + enable, "locate"));
      CHECK(column(ticks, "y") == column(located, "y"));
      CHECK(column(located, "held").back() == Approx(column(ticks, "held").back()).epsilon(1e-12));
    }
}

TEST_CASE("a hold of the time is a staircase between its ticks, whatever is located") {
  const table::Table run = run_text(with("ZeroOrderHold, u: t", "locate"));
  CHECK(column(run, "held").back() == Approx(0.45).epsilon(1e-12));  // 0.1 (0 + 0.1 + ... + 0.9)
}

TEST_CASE("a gain of a sampled signal and of a located one follows the located one") {
  // The machine leaves its first state at 0.25 s.
  const table::Table run = run_text(R"(step: 0.1 s
stop: 1 s
solver: rk4
events: locate
blocks:
  t: {block: Clock}
  hold: {block: ZeroOrderHold, u: t}
  m: {block: StateMachine, u: t, states: {a: {to: {b: u > 0.25}}, b: {output: 1}}}
  both: {block: Sum, u: [hold, m.y]}
  x: {block: Integrator, u: both}
record: [x]
)");
  CHECK(column(run, "x").back() == Approx(0.45 + 0.75).epsilon(1e-11));
}

}  // namespace stepwire::run

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("The model moves as the hand does that it is a model of") {
  const table::Table run = run_text(R"(
step: 1 ms
stop: 2 s
solver: rk4
blocks:
  goal:  {block: Step, time: 0.1 s, after: 10 mm}
  meant: {block: Mux, u: [goal, 0 m]}
  model: {block: ForwardModel, equilibrium: meant, stiffness: 270 N/m, damping: 9 N s/m, mass: 1.354 kg, muscle: 66 ms, every: 10 ms}
  held:  {block: ZeroOrderHold, u: goal, every: 10 ms}
  lag:   {block: Lag, u: held, tau: 66 ms}
  rate0: {block: Sum, signs: "+-", u: [held, lag]}
  rate:  {block: Gain, u: rate0, gain: = 1/(66 ms)}
  behind: {block: Sum, signs: "+-", u: [lag, hand.position]}
  slip:  {block: Sum, signs: "+-", u: [rate, hand.velocity]}
  spring: {block: Gain, u: behind, gain: 270 N/m}
  dashpot: {block: Gain, u: slip, gain: 9 N s/m}
  push:  {block: Sum, u: [spring, dashpot]}
  hand:  {block: Mass, force: push, mass: 1.354 kg}
record: {every: 10 ms, signals: [model.position, model.velocity, hand.position, hand.velocity]}
)");
  const auto &x = column(run, "model.position.1"), &of = column(run, "hand.position");
  for (std::size_t k = 0; k < x.size(); ++k) REQUIRE(x[k] == Approx(of[k]).margin(0.3e-3));
  CHECK(x.back() == Approx(10e-3).margin(0.1e-3));
  CHECK(column(run, "model.position.2").back() == 0.0);
}

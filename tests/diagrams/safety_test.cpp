// Faults are injected into the inputs of the safety part; the tests check the resulting currents.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

constexpr double linear = 0.3, rotary = 0.6, fault = 0.5, sample = 1e-3;

/// Makes a diagram of a pin that moves, the safety of the polar interface, and its amplifiers. The first
/// argument has the keys of the safety's inputs; `more` has the blocks that these name.
std::string rig(const std::string& told, const std::string& more = "") {
  return R"(
step: 0.1 ms
stop: 1 s
solver: rk4
blocks:
  fault:    {block: Step, time: 0.5 s, after: 1}
  pin:      {block: Ramp, slope: [10 mm/s, 20 mm/s], initial: [224 mm, 0 mm]}
  apart:    {block: Demux, u: pin, sizes: [1, 1]}
  length:   {block: Norm, u: pin, every: 1 ms}
  angle:    {block: Atan2, opposite: apart.y2, adjacent: apart.y1, every: 1 ms}
  hand:     {block: Sine, amplitude: 0.05 N, frequency: 31 Hz, bias: [8 N, 6 N]}
)" + more +
         R"(  safety: {diagram: ../diagrams/parts/safety.yaml, linear: 0.3 A, rotary: 0.6 A, other: pin, )" +
         told + R"(}
  amplifiers: {diagram: ../diagrams/parts/polar-amplifiers.yaml, linear: safety.linear, rotary: safety.rotary}
record: [amplifiers.linear, amplifiers.rotary, safety.cause]
)";
}

std::string held(const std::string& what) {
  return "  frozen: {block: Switch, control: fault, then: before, else: " + what +
         ", every: 1 ms}\n  before: {block: UnitDelay, u: frozen, every: 1 ms}\n";
}

/// Returns the time from which no current flows. Until then the currents must be those commanded.
double cut_off(const table::Table& table, double cause) {
  const auto &time = column(table, "time"), &first = column(table, "amplifiers.linear"),
             &second = column(table, "amplifiers.rotary");
  std::size_t k = time.size();
  while (k > 0 && std::abs(first[k - 1]) < 1e-6 && std::abs(second[k - 1]) < 1e-6) --k;
  // the start ramp ends after 0.1 s, and the board has steps of 0.12 mA
  for (std::size_t i = 0; i < k; ++i) {
    if (time[i] < 0.105 || time[i] > time[k - 1] - 2.0 * sample) continue;
    REQUIRE(first[i] == Approx(linear).margin(1e-4));
    REQUIRE(second[i] == Approx(rotary).margin(1e-4));
  }
  CHECK(column(table, "safety.cause").back() == cause);
  return time[k - 1];
}

/// Makes the paths of the parts absolute, for a text that has no folder.
std::string from_anywhere(std::string text) {
  const std::string here = "../diagrams";
  for (auto at = text.find(here); at != std::string::npos; at = text.find(here))
    text.replace(at, here.size(), STEPWIRE_SOURCE_DIR "/diagrams");
  return text;
}

/// Returns the command of the interlock to the linear damper.
double command_of(const run::Executor& simulation) {
  const plan::Plan& plan = simulation.plan();
  for (std::size_t b = 0; b < plan.blocks.size(); ++b)
    if (plan.diagram.blocks[b].name == "safety.interlock")
      return simulation.values()[plan.blocks[b].outputs[0].offset];
  throw std::logic_error("there is no interlock");
}

const std::string healthy = "position: pin, force: hand, length: length, angle: angle";

}  // namespace

TEST_CASE("As long as nothing is wrong the amplifiers give what is asked, after a ramp from 0") {
  const table::Table table = run_text(rig(healthy));
  CHECK(cut_off(table, 0.0) == 1.0);
  const auto &time = column(table, "time"), &current = column(table, "amplifiers.linear");
  for (std::size_t k = 0; k < time.size() && time[k] < 0.1; ++k)
    CHECK(current[k] <= linear * time[k] / 0.1 + 1e-4);
}

TEST_CASE("An excessive force leaves no current after one sample") {
  const table::Table table =
      run_text(rig("position: pin, force: blow, length: length, angle: angle",
                   "  hit: {block: Gain, u: fault, gain: 70 N}\n  blow: {block: Sum, u: [hand, hit]}\n"));
  CHECK(cut_off(table, 2.0) <= fault + sample);
}

TEST_CASE(
    "An excessive speed leaves no current one sample after it is seen, within the window of the speed") {
  const table::Table table = run_text(
      rig("position: flight, force: hand, length: length, angle: angle",
          "  away: {block: Ramp, slope: 2 m/s, start: 0.5 s}\n  flight: {block: Sum, u: [pin, away]}\n"));
  CHECK(cut_off(table, 3.0) <= fault + 41.0 * sample + sample);
}

TEST_CASE("A load cell that goes on showing the same leaves no current after the time that it may") {
  const double end =
      cut_off(run_text(rig("position: pin, force: frozen, length: length, angle: angle", held("hand"))), 4.0);
  CHECK(end >= fault + 0.1);
  CHECK(end <= fault + 0.1 + 3.0 * sample);
}

TEST_CASE("A potentiometer or an encoder that rests while another sensor sees it move leaves no current") {
  const double length =
      cut_off(run_text(rig("position: pin, force: hand, length: frozen, angle: angle", held("length"))), 5.0);
  const double angle =
      cut_off(run_text(rig("position: pin, force: hand, length: length, angle: frozen", held("angle"))), 6.0);
  for (double end : {length, angle}) {
    CHECK(end >= fault + 0.2);
    CHECK(end <= fault + 0.2 + 3.0 * sample);
  }
}

TEST_CASE("An encoder that jumps leaves no current after one sample") {
  CHECK(cut_off(run_text(rig(healthy + ", jumped: fault")), 7.0) <= fault + sample);
}

TEST_CASE("A device that drives the hand leaves no current once it has given out the budget") {
  // 8 N at 10 mm/s and 6 N at 20 mm/s take 0.25 s for 50 mJ; the speed is known 20 ms late
  const double end = cut_off(run_text(rig("position: pin, force: pulled, length: length, angle: angle",
                                          "  pulled: {block: Gain, u: hand, gain: -1}\n")),
                             8.0);
  CHECK(end == Approx(0.25 + 0.02).margin(0.01));
}

TEST_CASE(
    "Letting go of the dead-man switch leaves no current after one sample, and pressing it brings it back "
    "slowly") {
  const table::Table table = run_text(
      rig(healthy + ", dead_man: pressed",
          "  pressed: {block: Pulse, amplitude: -1, bias: 1, delay: 0.5 s, period: 10 s, width: 0.02}\n"));
  const auto &time = column(table, "time"), &current = column(table, "amplifiers.rotary");
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] > 0.5 + sample && time[k] < 0.7) CHECK(current[k] < 1e-6);
    if (time[k] >= 0.7 && time[k] < 0.8) CHECK(current[k] <= rotary * (time[k] - 0.7) / 0.1 + 1e-4);
  }
  CHECK(current.back() == Approx(rotary).margin(1e-4));
}

TEST_CASE("A reset after a fault brings the currents back by the ramp") {
  const table::Table table =
      run_text(rig("position: pin, force: blow, length: length, angle: angle, reset: button",
                   "  hit: {block: Pulse, amplitude: 70 N, delay: 0.3 s, period: 10 s, "
                   "width: 0.001}\n  blow: {block: Sum, u: "
                   "[hand, hit]}\n  button: {block: Step, time: 0.6 s, after: 1}\n"));
  const auto &time = column(table, "time"), &current = column(table, "amplifiers.linear");
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] > 0.3 + sample && time[k] < 0.6) CHECK(current[k] < 1e-6);
    if (time[k] >= 0.6 && time[k] < 0.7) CHECK(current[k] <= linear * (time[k] - 0.6) / 0.1 + 1e-4);
  }
  CHECK(current.back() == Approx(linear).margin(1e-4));
}

TEST_CASE("With stop the first fault ends the experiment, and is named") {
  CHECK_THAT(error_of(rig(healthy + ", jumped: fault, stop: true")),
             Catch::Contains("safety.interlock") && Catch::Contains("encoder jumped (cause 7)") &&
                 Catch::Contains("0.5 s"));
}

TEST_CASE(
    "A sensor whose number is none leaves no command at the tick that shows it, with which the run ends") {
  const plan::Plan plan = plan_text(from_anywhere(
      rig("position: pin, force: hand, length: broken, angle: angle",
          "  clock: {block: Clock}\n  broken: {block: Expression, u: [length, clock], expression: \"u1 + "
          "0*sqrt(0.4995 - u2)\", every: 1 ms}\n")));
  run::Executor simulation(plan);
  double last = 0.0;
  while (simulation.healthy()) {
    last = command_of(simulation);
    simulation.evaluate();
    if (simulation.healthy()) simulation.advance();
  }
  CHECK(last == linear);
  CHECK(simulation.tick() == 5000);
  CHECK(command_of(simulation) == 0.0);
}

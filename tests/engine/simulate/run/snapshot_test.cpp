#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

/// Everything that has a memory: continuous and discrete states, noise, delays, diagnostics, several rates.
const std::string everything = R"(step: 1 ms
stop: 0.5 s
solver: rk4
blocks:
  noise: {block: Noise, seed: 4, every: 3 ms}
  drive: {block: Sum, signs: "+-", u: [noise, late]}
  plant: {block: TransferFunction, numerator: [1], denominator: [1, 0.2, 900], u: drive}
  late: {block: Delay, delay: 20 ms, u: plant}
  slow: {block: UnitDelay, u: plant, every: 10 ms}
  x: {block: Integrator, u: slow, upper: 1e-4}
  lash: {block: Backlash, width: 1e-4, u: plant}
  damper: {block: MRDamper, preset: rd-1097-01, velocity: noise, current: 0.2 A, integration: exact}
  mean: {block: MovingAverage, window: 60 ms, u: noise}
record: all
)";

/// Returns the numbers of a simulation at every tick until its end.
std::vector<std::vector<double>> rest_of(Executor& simulation) {
  std::vector<std::vector<double>> ticks;
  while (true) {
    simulation.evaluate();
    ticks.push_back(simulation.workspace().values);
    if (simulation.finished()) return ticks;
    simulation.advance();
  }
}

}  // namespace

TEST_CASE("a run from a kept moment gives the same bits as the run that went through it") {
  const plan::Plan plan = plan_text(everything);
  Executor whole(plan);
  const auto in_one_go = rest_of(whole);
  REQUIRE(in_one_go.size() == 501);
  for (const int tick : {0, 1, 137, 250, 499, 500}) {
    INFO("kept at tick " << tick);
    Executor first(plan);
    for (int k = 0; k < tick; ++k) {
      first.evaluate();
      first.advance();
    }
    const Workspace kept = first.workspace();
    const auto continued = rest_of(first);
    Executor second(plan);
    second.restore(kept);
    const auto restored = rest_of(second);
    first.restore(kept);  // back in time on the same simulation
    const auto again = rest_of(first);
    const std::vector<std::vector<double>> expected(in_one_go.begin() + tick, in_one_go.end());
    CHECK((continued == expected && restored == expected && again == expected));
  }
}

TEST_CASE("modes at a tick are those of a run that goes back to it, where events are located") {
  const plan::Plan plan = plan_text(R"(step: 1 ms
stop: 70 ms
events: locate
stop_when: stop.y > 1 kN
blocks:
  push: {block: Sine}
  held: {block: Karnopp, force: push, velocity: 0.5, band: 1.3 m/s, mass: 0.35 kg, coulomb: 0.7 N}
  speed: {block: Gain, u: held.y, gain: -0.2 m/(N s)}
  stop: {block: HardStop, force: 0.5, position: 0.5, velocity: speed, mass: 0.24 kg, upper: 0.23 m}
record: all
)");
  Executor whole(plan);
  const auto in_one_go = rest_of(whole);
  Executor first(plan);
  for (std::size_t tick = 0; tick < 70; ++tick) {
    INFO("kept at tick " << tick);
    const Workspace kept = first.workspace();
    const auto rest = rest_of(first);
    CHECK(rest.front() == in_one_go[tick]);
    first.restore(kept);
    first.evaluate();
    CHECK(first.workspace().values == in_one_go[tick]);
    first.advance();
  }
}

TEST_CASE("a controller whose only memory is its integral shows it after a return, too") {
  const plan::Plan plan = plan_text(R"(step: 1 ms
stop: 44 ms
solver: heun
blocks:
  c: {block: PID, u: 0.5, ki: 1.603, anti_windup: none, settled: false}
record: [c]
)");
  Executor whole(plan), first(plan);
  const auto in_one_go = rest_of(whole);
  for (const double time : {0.0, 0.02, 0.044}) {
    const auto tick = static_cast<std::size_t>(std::lround(1000.0 * time));
    CHECK(in_one_go[tick][plan.slot({0, 0, -1}).offset] == Approx(0.5 + 0.5 * 1.603 * time));
  }
  for (std::size_t tick = 0; tick < 44; ++tick) {
    INFO("kept at tick " << tick);
    const Workspace kept = first.workspace();
    rest_of(first);
    first.restore(kept);
    first.evaluate();
    CHECK(first.workspace().values == in_one_go[tick]);
    first.advance();
  }
}

TEST_CASE("the runner records what a run stepped by hand computes") {
  const plan::Plan plan = plan_text(everything);
  const RunResult result = run_plan(plan);
  Executor by_hand(plan);
  const auto ticks = rest_of(by_hand);
  const table::Table& table = result.recordings.front().table;
  REQUIRE(table.rows() == ticks.size());
  for (const diagram::RecordedSignal& signal : plan.diagram.records.front().signals) {
    INFO(signal.name);
    const auto& column = table.find(signal.name)->values;
    const std::size_t offset = plan.slot(signal.signal).offset;
    bool same = true;
    for (std::size_t row = 0; row < column.size(); ++row) same = same && column[row] == ticks[row][offset];
    CHECK(same);
  }
}

TEST_CASE("a run put back to its beginning gives the same bits") {
  const plan::Plan plan = plan_text(everything);
  Executor simulation(plan);
  const auto first = rest_of(simulation);
  simulation.reset();
  CHECK(first == rest_of(simulation));
}

}  // namespace stepwire::run

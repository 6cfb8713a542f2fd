#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::run {

namespace {

const std::string swing_yaml = R"(step: 10 ms
stop: 1 s
solver: rk4
blocks:
  pull: {block: Gain, gain: -1, u: x}
  v: {block: Integrator, u: pull}
  x: {block: Integrator, u: v, initial: 1}
  slow: {block: UnitDelay, u: x, every: 50 ms}
)";

struct Counter : ScheduleProbe {
  void enter() override { ++entered; }
  void leave() override { left += entered - left == 1; }
  int entered = 0, left = 0;
};

/// How often a stretch runs in ten ticks.
int runs_of(const std::vector<plan::KernelCall> plan::Plan::*phase, std::size_t first, std::size_t end) {
  const plan::Plan plan = plan_text(swing_yaml);
  Executor simulation(plan), unwatched(plan);
  Counter counter;
  counter.phase = &(plan.*phase);
  counter.first = first;
  counter.end = end;
  simulation.watch(&counter);
  for (int tick = 0; tick < 10; ++tick)
    for (Executor* each : {&simulation, &unwatched}) {
      each->evaluate();
      each->advance();
    }
  CHECK(counter.left == counter.entered);
  CHECK(simulation.workspace().values == unwatched.workspace().values);
  simulation.watch(nullptr);
  simulation.evaluate();
  CHECK(counter.left == counter.entered);
  return counter.entered;
}

}  // namespace

TEST_CASE("a watcher is told each time that its stretch of a phase runs, and changes no bit") {
  CHECK(runs_of(&plan::Plan::outputs, 0, 1) == 10);
  CHECK(runs_of(&plan::Plan::updates, 0, 1) == 10);      // called even if none of its blocks is due
  CHECK(runs_of(&plan::Plan::derivatives, 0, 1) == 40);  // four stages of rk4
  CHECK(runs_of(&plan::Plan::stage, 0, 1) == 30);        // the first stage is the tick itself
  CHECK(runs_of(&plan::Plan::outputs, 0, 0) == 10);      // an empty stretch
}

}  // namespace stepwire::run

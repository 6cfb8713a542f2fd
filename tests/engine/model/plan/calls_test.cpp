// Number of calls of each phase of a block, measured by blocks that count them.
#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::plan {

namespace {

int held_calls, timed_calls, followed_calls, aside_calls, once_calls;

/// Passes its input on and counts its calls.
template <int& calls>
struct Counter {
  Input<> u{};
  Output<> y{};

  void outputs() {
    ++calls;
    y = u;
  }
  static void declare(Declare<Counter>& is) {
    is.block(&calls == &held_calls       ? "Held"
             : &calls == &timed_calls    ? "Timed"
             : &calls == &followed_calls ? "Followed"
             : &calls == &aside_calls    ? "Aside"
                                         : "Once",
             {.doc = "a test", .smooth = true});
    is.template input<&Counter::u>({.unit = "*", .doc = "signal"});
    is.template output<&Counter::y>({.unit = "*", .doc = "the same"});
  }
};

Registry with_counters() {
  Registry registry = blocks();
  registry.add<Counter<held_calls>>("test");
  registry.add<Counter<timed_calls>>("test");
  registry.add<Counter<followed_calls>>("test");
  registry.add<Counter<aside_calls>>("test");
  registry.add<Counter<once_calls>>("test");
  return registry;
}

}  // namespace

TEST_CASE(
    "between ticks the solver asks only blocks that derivatives need, and those of time alone once for each "
    "time") {
  static const Registry registry = with_counters();
  const Plan plan = plan_text(R"(blocks:
  t: {block: Clock}
  held: {block: Held, u: t, every: 5 s}
  timed: {block: Timed, u: t}
  followed: {block: Followed, u: x}
  aside: {block: Aside, u: x}
  once: {block: Once, u: 3}
  rate: {block: Sum, u: [held, timed, followed, once]}
  x: {block: Integrator, u: rate}
step: 1 s
stop: 10 s
solver: rk4
)",
                              {}, registry);
  run::Executor simulation(plan);
  held_calls = timed_calls = followed_calls = aside_calls = once_calls = 0;
  simulation.reset();
  while (!simulation.finished()) {
    simulation.evaluate();
    simulation.advance();
  }
  simulation.evaluate();
  CHECK(held_calls == 3);                // at 0, 5 and 10 s
  CHECK(timed_calls == 1 + 10 * 2);      // at the start, and at two new times of each step
  CHECK(followed_calls == 11 + 10 * 3);  // at every tick and three later stages of each step
  CHECK(aside_calls == 11);              // no derivative uses it
  CHECK(once_calls == 1);                // constant: computed once
}

TEST_CASE("what only feeds on constants is a constant, whatever stands in between") {
  const Plan plan = plan_text(
      "blocks:\n  a: {block: Gain, gain: 2, u: 3}\n  b: {block: Sum, u: [a, a, 1]}\n  c: {block: Constant, "
      "value: 4}\n"
      "  d: {block: Product, u: [c, b]}\n");
  for (const PlannedBlock& block : plan.blocks) CHECK(block.rate.kind == Rate::Kind::constant);
  CHECK(plan.outputs.empty());
  run::Executor simulation(plan);
  simulation.evaluate();
  CHECK(simulation.values()[plan.blocks[3].outputs[0].offset] == 52.0);
}

}  // namespace stepwire::plan

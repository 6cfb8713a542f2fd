// Rules for every block in a run, whatever it computes; checked in diagrams made from the declarations.
#include <catch2/catch.hpp>

#include "engine/base/yaml/yaml_text.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "tests/blocks/contract_rig.hpp"
#include "tests/support/allocations.hpp"

using namespace stepwire;

namespace {

/// Calls `check` with every plan in which the library's blocks are tried.
template <class Check>
void for_every_plan(const Check& check) {
  for (const BlockType* type : library().types())
    for (const Wiring& wiring : wirings_of(*type)) {
      INFO(wiring.text);
      std::optional<plan::Plan> plan;
      REQUIRE_NOTHROW(plan = plan_of(wiring));
      if (plan) check(*plan);
    }
}

void run_to(run::Executor& simulation, std::int64_t tick) {
  while (simulation.tick() < tick && simulation.healthy()) {
    simulation.evaluate();
    simulation.advance();
  }
}

std::vector<double> region(const run::Executor& simulation, std::size_t first, std::size_t count) {
  const double* start = simulation.values() + first;
  return {start, start + count};
}

/// All that lasts from tick to tick: states and diagnostics.
std::vector<double> memory_of(const run::Executor& simulation) {
  const plan::Layout& layout = simulation.plan().layout;
  std::vector<double> memory = region(simulation, layout.states, layout.state_count);
  for (double number : region(simulation, layout.discrete, layout.discrete_count)) memory.push_back(number);
  for (double number : region(simulation, layout.diagnostics, layout.diagnostic_count))
    memory.push_back(number);
  return memory;
}

}  // namespace

TEST_CASE("every block runs with neutral inputs") {
  for (const BlockType* type : library().types()) {
    const Wiring wiring = wirings_of(*type).front();
    INFO(wiring.text);
    std::optional<plan::Plan> plan;
    REQUIRE_NOTHROW(plan = plan_of(wiring));
    run::Executor simulation(*plan);
    run_to(simulation, plan->steps);
    simulation.evaluate();
    if (const auto fault = simulation.fault()) FAIL_CHECK(fault->fault.text());
    CHECK(simulation.finished());
  }
}

TEST_CASE("no block allocates in a step") {
  for_every_plan([](const plan::Plan& plan) {
    run::Executor simulation(plan);
    const long before = allocations();
    run_to(simulation, plan.steps);
    const long after = allocations();
    CHECK(after == before);
  });
}

TEST_CASE("outputs() has no side effect: evaluated twice, a tick has the same bits, and no state has moved") {
  for_every_plan([](const plan::Plan& plan) {
    run::Executor simulation(plan);
    for (std::int64_t tick = 0; tick < plan.steps && simulation.healthy(); ++tick) {
      const std::vector<double> memory = memory_of(simulation);
      simulation.evaluate();
      const std::vector<double> first = numbers_of(simulation);
      CHECK(same_bits(memory_of(simulation), memory));
      simulation.evaluate();
      CHECK(same_bits(numbers_of(simulation), first));
      simulation.advance();
    }
  });
}

TEST_CASE("two runs give the same bits") {
  for_every_plan([](const plan::Plan& plan) {
    run::Executor one(plan), other(plan);
    run_to(one, plan.steps);
    run_to(other, plan.steps);
    CHECK(same_bits(numbers_of(one), numbers_of(other)));
    other.reset();
    run_to(other, plan.steps);
    CHECK(same_bits(numbers_of(one), numbers_of(other)));
  });
}

TEST_CASE("a run goes on from a kept moment with the same bits, also in another simulation") {
  for_every_plan([](const plan::Plan& plan) {
    run::Executor simulation(plan), fresh(plan);
    run_to(simulation, plan.steps / 2);
    if (!simulation.healthy()) return;
    const run::Workspace kept = simulation.workspace();
    run_to(simulation, plan.steps);
    const std::vector<double> end = numbers_of(simulation);
    simulation.restore(kept);
    run_to(simulation, plan.steps);
    CHECK(same_bits(numbers_of(simulation), end));
    fresh.restore(kept);
    run_to(fresh, plan.steps);
    CHECK(same_bits(numbers_of(fresh), end));
  });
}

TEST_CASE("a parameter that is set in a run to the value that it has changes nothing") {
  for_every_plan([](const plan::Plan& plan) {
    const std::size_t tested = tested_in(plan);
    const BlockType& type = plan.diagram.blocks[tested].type();
    run::Executor untouched(plan);
    run_to(untouched, plan.steps / 2);
    const run::Workspace kept = untouched.workspace();
    run_to(untouched, plan.steps);
    for (std::size_t p = 0; p < type.parameters.size(); ++p) {
      const diagram::Target target{diagram::Target::Kind::parameter, static_cast<int>(tested),
                                   static_cast<int>(p), 0};
      const auto value = diagram::flattened_value(plan.diagram, target, diagram::absolute_path);
      if (!value) continue;
      INFO(diagram::name_of(plan.diagram, target) << ": " << yaml::yaml_line(*value));
      run::Executor run(plan);
      run.restore(kept);
      const diagram::Variation variation(plan.diagram, {diagram::name_of(plan.diagram, target)});
      const diagram::Assignment assignment{variation.names()[0].text, *value, "test"};
      const bool done = run.set(variation, {&assignment, 1}) == run::Executor::Setting::done;
      CHECK(done != type.file_output);
      run_to(run, plan.steps);
      CHECK(same_bits(numbers_of(run), numbers_of(untouched)));
    }
  });
}

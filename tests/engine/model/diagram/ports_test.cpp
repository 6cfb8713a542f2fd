#include <catch2/catch.hpp>

#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string doubled =
    "inputs: {force: {unit: N, default: 3 N, doc: of the hand}}\n"
    "outputs: {half: {signal: half, safe: 0.5 N}, plain: half}\n"
    "blocks: {half: {block: Gain, gain: 0.5, u: force}}\n"
    "record: [half]\n";

double half_of(const run::Executor& simulation) {
  return simulation.values()[simulation.plan().slot(simulation.plan().diagram.outputs[0].signal).offset];
}

}  // namespace

TEST_CASE("an input of the diagram itself holds its default until somebody writes it") {
  const plan::Plan plan = plan_text(doubled);
  REQUIRE(plan.diagram.inputs.size() == 1);
  CHECK(plan.diagram.inputs[0].name == "force");
  CHECK(plan.diagram.inputs[0].doc == "of the hand");
  run::Executor simulation(plan);
  simulation.evaluate();
  CHECK(half_of(simulation) == 1.5);
  const double written = 8.0;
  simulation.write_input(0, &written);
  simulation.evaluate();
  CHECK(half_of(simulation) == 4.0);
  simulation.reset();
  simulation.evaluate();
  CHECK(half_of(simulation) == 1.5);
}

TEST_CASE("an output of the diagram itself knows its signal and its safe value") {
  const plan::Plan plan = plan_text(doubled);
  REQUIRE(plan.diagram.outputs.size() == 2);
  CHECK(plan.diagram.outputs[0].name == "half");
  CHECK((*plan.diagram.outputs[0].safe)[0] == 0.5);
  CHECK_FALSE(plan.diagram.outputs[1].safe);
}

TEST_CASE("the declared unit of an input is that of what it feeds") {
  CHECK(faults_of("inputs: {force: {unit: N, default: 3 mm}}\n"
                  "blocks: {half: {block: Gain, u: force}}\n") ==
        std::vector<std::string>{"test.yaml:1:36: force: is in m; it must be in N"});
}

TEST_CASE("a safe value of another unit or size than its output is refused") {
  const auto with_safe = [](const std::string& safe) {
    return faults_of(
        "inputs: {force: {unit: N, default: [1, 2]}}\n"
        "outputs: {held: {signal: held, safe: " +
        safe + "}}\nblocks: {held: {block: Saturation, lower: 0, upper: 1, u: force}}\n");
  };
  CHECK(with_safe("0 N").empty());
  CHECK(with_safe("[0 N, 1 N]").empty());
  CHECK(with_safe("0 A") == std::vector<std::string>{"test.yaml:2:11: held.safe: is in A; it must be in N"});
  CHECK(with_safe("[1, 2, 3]") ==
        std::vector<std::string>{"test.yaml:2:11: held.safe: has 3 elements where the signal has 2"});
}

}  // namespace stepwire::diagram

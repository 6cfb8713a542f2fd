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

TEST_CASE("a default without unit is refused where the port is in a unit other than SI") {
  const auto fault = [](const std::string& port) {
    const auto all = faults_of("inputs: {x: " + port + "}\nblocks: {y: {block: Gain, gain: 2, u: x}}\n");
    return all.empty() ? std::string() : all.front();
  };
  CHECK(fault("{unit: mm, default: 2}") ==
        "test.yaml:1:33: x: 2 has no unit, but the port is in mm; write 2 mm");
  CHECK_THAT(fault("{unit: degC, default: 20}"), Catch::Contains("write 20 degC"));
  CHECK_THAT(fault("{unit: deg, default: [0, 20]}"), Catch::Contains("write 20 deg"));
  for (const char* right : {"{unit: mm, default: 2 mm}", "{unit: mm, default: 0}", "{unit: m, default: 2}",
                            "{unit: mm, default: [1 mm, 2 cm]}"})
    CHECK(fault(right) == "");
}

TEST_CASE("a port has one unit, and a list of units is refused") {
  CHECK(faults_of("inputs: {x: {unit: [m, rad], default: [0, 0]}}\n"
                  "blocks: {y: {block: Gain, gain: 2, u: x}}\n")
            .at(0) == "test.yaml:1:20: x: has one unit; a bus has 'fields' with a unit for each");
}

}  // namespace stepwire::diagram

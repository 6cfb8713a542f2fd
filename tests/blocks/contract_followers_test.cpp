// The numbers of a block that follow from a parameter are known before any value is set; checked for every
// block.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/model/diagram/load.hpp"
#include "tests/blocks/contract_values.hpp"

using namespace stepwire;

namespace {

plan::Plan plan_beside(const std::string& yaml) {
  diagram::Loader loader(library());
  const auto beside = std::filesystem::path(STEPWIRE_SOURCE_DIR) / "tests" / "blocks" / "contract.yaml";
  return plan::make_plan(loader.load_text(yaml, beside.string()));
}

/// Sets a parameter in a run of the plan; false where that is refused, or takes another plan.
bool takes(run::Executor& run, const std::string& name, const Value& value) {
  try {
    return run.set(name, yaml_of(value)) == run::Executor::Setting::done;
  } catch (const yaml::Error&) {
    return false;
  }
}

/// All numbers of a block by its members.
std::vector<double> numbers_in(const AnyBlock& block) {
  return plan::MemberItems(block.type(), block.get()).numbers();
}

/// Sets each parameter of the tested block to other values. How many numbers moved.
std::size_t check_followers(const plan::Plan& plan) {
  std::size_t moved = 0;
  const std::size_t tested = tested_in(plan);
  const AnyBlock& block = plan.diagram.blocks[tested].block;
  for (const diagram::DiagramParameter& parameter : plan.diagram.parameters) {
    const ParameterSpec* spec = block.type().parameter(parameter.name.substr(2));
    const auto variable = plan::variable_blocks(plan, diagram::Variation(plan.diagram, {parameter.name}));
    for (const auto& [factor, more] : std::vector<std::pair<double, double>>{
             {1.001, 0.0}, {1.25, 0.0}, {0.7, 0.1}, {2.0, 3.0}, {0.0, 1.0}}) {
      run::Executor run(plan);
      const Value value = changed(parameter.value, factor, more, spec->kind == ParameterKind::integer);
      INFO(parameter.name << ": " << yaml_of(value));
      if (!takes(run, parameter.name, value)) continue;
      const std::vector<double> before = numbers_in(block),
                                after = numbers_in(run.diagram().blocks[tested].block);
      if (before.size() != after.size()) continue;  // a list has another length, which the run finds
      auto found = variable;
      run.widen(found);
      for (std::size_t i = 0; i < found.size(); ++i) CHECK((found[i].items == variable[i].items));
      moved += before != after ? 1 : 0;
    }
  }
  return moved;
}

}  // namespace

TEST_CASE("of every block, compiled code reads each number that moves with a parameter") {
  std::size_t moved = 0;
  for (const BlockType* type : library().types()) {
    if (type->header.empty() || type->file_output) continue;
    for (const Wiring& wiring : wirings_of(*type)) {
      const std::string yaml = wiring.may_be_refused ? "" : with_parameters(wiring);
      if (yaml.empty()) continue;
      INFO(yaml);
      moved += check_followers(plan_beside(yaml));
    }
  }
  CHECK(moved > 500);
}

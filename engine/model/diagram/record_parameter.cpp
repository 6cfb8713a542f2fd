#include "engine/model/diagram/record_parameter.hpp"

#include <algorithm>

#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

namespace {

/// Returns the block with the value of a parameter; adds a fault and returns -1 for a parameter that is not
/// numeric.
int block_of_parameter(const yaml::Node& node, const std::string& name, const Scope& scope, Report& report) {
  std::vector<DiagramBlock>& blocks = report.diagram().blocks;
  const auto known = std::ranges::find(blocks, name, &DiagramBlock::name);
  if (known != blocks.end()) return static_cast<int>(known - blocks.begin());
  const ParameterSpec& spec = parameter_value_type().parameters.front();
  ParameterUses uses;
  const auto written =
      ValueReader(scope.parameters, report, scope.index, &uses).read_for(spec, {}, node, "record");
  if (!written) return -1;
  const int index = static_cast<int>(blocks.size());
  DiagramBlock& block = blocks.emplace_back(name, parameter_value_type());
  block.origin = scope.at(node.mark);
  block.parameter_marks.push_back(node.mark);
  block.parameter_dimensions.push_back(written->dimension);
  if (written->columns > 1) block.matrices.emplace_back(0, written->columns);
  spec.set(block.block.get(), written->value);
  report.bindings().bindings.push_back(
      {{Target::Kind::parameter, index, 0}, {node, scope.index, scope.index}, std::move(uses)});
  return index;
}

}  // namespace

void record_parameter(const yaml::Node& node, const std::string& name, const Scope& scope,
                      RecordRequest& request, Report& report) {
  const int block = block_of_parameter(node, "parameters." + node.text.substr(1), scope, report);
  if (block >= 0) request.signals.push_back({name, {block, 0, -1}, scope.at(node.mark)});
}

}  // namespace stepwire::diagram

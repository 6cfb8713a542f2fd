#include "engine/model/plan/draft.hpp"

#include <algorithm>

#include "engine/model/diagram/output_names.hpp"

namespace stepwire::plan {

bool Draft::depends(std::size_t block, std::size_t input, std::size_t output) const {
  const InputSpec& in = type(block).inputs[input];
  if (blocks[block].says.feedthrough.empty()) return in.feedthrough;
  const auto said = blocks[block].says.feedthrough.find({in.name, type(block).outputs[output].name});
  return said == blocks[block].says.feedthrough.end() ? in.feedthrough : said->second;
}

bool Draft::is_state(std::size_t block, std::size_t output) const {
  return diagram::is_bare_state(type(block), output) ||
         (!blocks[block].computes && !type(block).outputs[output].state.empty());
}

diagram::OutputShapes output_shapes(const Draft& draft) {
  diagram::OutputShapes shapes;
  for (const Draft::Block& block : draft.blocks) {
    auto& of_block = shapes.emplace_back();
    for (std::size_t o = 0; o < block.output_sizes.size(); ++o)
      of_block.push_back({static_cast<std::size_t>(block.output_sizes[o]),
                          static_cast<std::size_t>(std::max<Eigen::Index>(block.output_columns[o], 1))});
  }
  return draft.report.faults().empty() ? shapes : diagram::OutputShapes{};
}

}  // namespace stepwire::plan

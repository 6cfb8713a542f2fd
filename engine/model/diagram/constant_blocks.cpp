#include "engine/model/diagram/constant_blocks.hpp"

#include <algorithm>

#include "engine/model/diagram/guard_types.hpp"

namespace stepwire::diagram {

namespace {

bool is_triggered(const Diagram& diagram, const DiagramBlock& block) {
  const auto trigger = static_cast<std::size_t>(guard_type().input("trigger"));
  for (int guard = block.guard; guard >= 0; guard = diagram.blocks[static_cast<std::size_t>(guard)].guard)
    if (!diagram.blocks[static_cast<std::size_t>(guard)].inputs[trigger].empty()) return true;
  return false;
}

/// True where a block has a rate whatever it reads.
bool has_rate(const Diagram& diagram, const DiagramBlock& block) {
  const BlockType& type = block.type();
  return type.timing != Timing::inherited || type.run_update || (block.every && !block.every_of_part) ||
         &type == &guard_type() || is_triggered(diagram, block);
}

bool reads(const DiagramBlock& block, const std::vector<bool>& constant) {
  return std::ranges::any_of(block.inputs, [&](const std::vector<Source>& sources) {
    return std::ranges::any_of(sources, [&](const Source& source) {
      return source.block >= 0 && !constant[static_cast<std::size_t>(source.block)];
    });
  });
}

}  // namespace

std::vector<bool> constant_blocks(const Diagram& diagram) {
  std::vector<bool> constant;
  for (const DiagramBlock& block : diagram.blocks) constant.push_back(!has_rate(diagram, block));
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t b = 0; b < constant.size(); ++b)
      if (constant[b] && reads(diagram.blocks[b], constant)) {
        constant[b] = false;
        changed = true;
      }
  }
  return constant;
}

}  // namespace stepwire::diagram

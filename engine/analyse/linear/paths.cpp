#include "engine/analyse/linear/paths.hpp"

#include <algorithm>
#include <numeric>

namespace stepwire::linear {

namespace {

using Neighbours = std::vector<std::vector<std::size_t>>;

std::vector<char> reached(const Neighbours& neighbours, const std::vector<int>& starts) {
  std::vector<char> found(neighbours.size(), 0);
  std::vector<std::size_t> queue(starts.begin(), starts.end());
  while (!queue.empty()) {
    const std::size_t block = queue.back();
    queue.pop_back();
    if (std::exchange(found[block], 1)) continue;
    queue.insert(queue.end(), neighbours[block].begin(), neighbours[block].end());
  }
  return found;
}

/// True for a block with a rate of its own. A block that follows its inputs' rate does not sample by itself.
bool samples(const diagram::DiagramBlock& block) {
  return !block.inputs.empty() && (block.every || block.type().timing == Timing::discrete);
}

}  // namespace

bool Paths::sampled() const {
  for (std::size_t b = 0; b < samples.size(); ++b)
    if (samples[b] && on_way(b)) return true;
  return false;
}

Paths find_paths(const plan::Plan& plan, const std::vector<int>& inputs, const std::vector<int>& outputs,
                 const std::vector<int>& cut) {
  const auto& blocks = plan.diagram.blocks;
  Neighbours readers(blocks.size()), sources(blocks.size());
  Paths paths;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    paths.samples.push_back(samples(blocks[b]));
    if (std::ranges::count(cut, static_cast<int>(b)) > 0) continue;
    for (const auto& list : blocks[b].inputs)
      for (const diagram::Source& source : list) {
        if (source.block < 0) continue;
        readers[static_cast<std::size_t>(source.block)].push_back(b);
        sources[b].push_back(static_cast<std::size_t>(source.block));
      }
  }
  paths.from_inputs = reached(readers, inputs);
  paths.to_outputs = reached(sources, outputs);
  return paths;
}

std::int64_t base_period(const plan::Plan& plan, const Paths& paths) {
  std::int64_t period = 1;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b)
    if (paths.samples[b] && paths.on_way(b)) period = std::lcm(period, plan.blocks[b].rate.ticks);
  return period;
}

}  // namespace stepwire::linear

#include "engine/app/fmu/dependencies.hpp"

#include <algorithm>

namespace stepwire::fmu {

bool Dependencies::feeds_through(int block, std::size_t input, int output) const {
  const auto b = static_cast<std::size_t>(block);
  const BlockType& type = plan_.diagram.blocks[b].type();
  const InputSpec& in = type.inputs[input];
  const auto& configuration = plan_.blocks[b].configuration;
  if (!configuration) return in.feedthrough;
  const auto said =
      configuration->feedthrough.find({in.name, type.outputs[static_cast<std::size_t>(output)].name});
  return said == configuration->feedthrough.end() ? in.feedthrough : said->second;
}

void Dependencies::add_own(int block, std::set<int>& to) const {
  const auto b = static_cast<std::size_t>(block);
  const bool is_input = std::ranges::any_of(
      plan_.diagram.inputs, [&](const diagram::DiagramInput& input) { return input.block == block; });
  if (is_input || plan_.diagram.blocks[b].type().has_continuous_state()) to.insert(block);
}

std::vector<Dependencies::Output> Dependencies::sources_of(int block, std::size_t input) const {
  std::vector<Output> sources;
  for (const diagram::Source& source : plan_.diagram.blocks[static_cast<std::size_t>(block)].inputs[input])
    if (source.block >= 0) sources.emplace_back(source.block, source.output);
  return sources;
}

std::set<int> Dependencies::of_outputs(std::vector<Output> open) const {
  std::set<Output> seen(open.begin(), open.end());
  std::set<int> found;
  const auto add = [&](const Output& output) {
    if (seen.insert(output).second) open.push_back(output);
  };
  while (!open.empty()) {
    const auto [block, output] = open.back();
    open.pop_back();
    add_own(block, found);
    const diagram::DiagramBlock& of = plan_.diagram.blocks[static_cast<std::size_t>(block)];
    for (std::size_t input = 0; input < of.inputs.size(); ++input)
      if (feeds_through(block, input, output)) std::ranges::for_each(sources_of(block, input), add);
    if (of.guard >= 0) add({of.guard, 0});
  }
  return found;
}

std::set<int> Dependencies::of(const diagram::SignalRef& signal) const {
  if (signal.output >= 0) return of_outputs({{signal.block, signal.output}});
  std::set<int> own;
  add_own(signal.block, own);
  return own;
}

std::set<int> Dependencies::of_slopes(int block) const {
  std::vector<Output> sources;
  const std::size_t inputs = plan_.diagram.blocks[static_cast<std::size_t>(block)].inputs.size();
  for (std::size_t input = 0; input < inputs; ++input) {
    const std::vector<Output> more = sources_of(block, input);
    sources.insert(sources.end(), more.begin(), more.end());
  }
  std::set<int> found = of_outputs(std::move(sources));
  add_own(block, found);
  return found;
}

}  // namespace stepwire::fmu

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

void Dependencies::add_input(int block, std::size_t input, std::set<int>& to) {
  for (const diagram::Source& source : plan_.diagram.blocks[static_cast<std::size_t>(block)].inputs[input])
    if (source.block >= 0) {
      const std::set<int> more = of_output(source.block, source.output);
      to.insert(more.begin(), more.end());
    }
}

// Returns the dependencies of an output, memoized. The entry exists before the recursion, so an algebraic
// loop ends at its second visit.
const std::set<int>& Dependencies::of_output(int block, int output) {
  const auto [known, is_new] = known_.try_emplace({block, output});
  if (!is_new) return known->second;
  std::set<int> found;
  add_own(block, found);
  const diagram::DiagramBlock& of = plan_.diagram.blocks[static_cast<std::size_t>(block)];
  for (std::size_t input = 0; input < of.inputs.size(); ++input)
    if (feeds_through(block, input, output)) add_input(block, input, found);
  if (of.guard >= 0) {
    const std::set<int> more = of_output(of.guard, 0);
    found.insert(more.begin(), more.end());
  }
  return known->second = std::move(found);
}

std::set<int> Dependencies::of(const diagram::SignalRef& signal) {
  if (signal.output >= 0) return of_output(signal.block, signal.output);
  std::set<int> own;
  add_own(signal.block, own);
  return own;
}

std::set<int> Dependencies::of_slopes(int block) {
  std::set<int> found;
  add_own(block, found);
  const std::size_t inputs = plan_.diagram.blocks[static_cast<std::size_t>(block)].inputs.size();
  for (std::size_t input = 0; input < inputs; ++input) add_input(block, input, found);
  return found;
}

}  // namespace stepwire::fmu

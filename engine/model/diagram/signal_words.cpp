#include "engine/model/diagram/signal_words.hpp"

namespace stepwire::diagram {

namespace {

void gather(const Value& states, const std::string& holder, std::vector<std::string>& names) {
  if (!states.map()) return;
  for (const auto& [name, state] : *states.map()) {
    names.push_back(holder + name);
    if (const Value* inner = state.find("states")) gather(*inner, holder + name + ".", names);
  }
}

}  // namespace

std::vector<std::string> signal_words(const Diagram& diagram, const SignalRef& signal) {
  if (signal.block < 0 || signal.output < 0) return {};
  const DiagramBlock& block = diagram.blocks[static_cast<std::size_t>(signal.block)];
  if (block.type().outputs[static_cast<std::size_t>(signal.output)].name != "state") return {};
  const ParameterSpec* states = block.type().parameter("states");
  std::vector<std::string> names;
  if (states && states->kind == ParameterKind::tree) gather(states->get(block.block.get()), "", names);
  return names;
}

}  // namespace stepwire::diagram

#include "engine/model/diagram/named_signals.hpp"
#include "engine/model/diagram/output_names.hpp"

namespace stepwire::diagram {

namespace {

void add_signals(const DiagramBlock& block, int index, std::map<std::string, SignalRef>& all) {
  const BlockType& type = block.type();
  for (std::size_t o = 0; o < type.outputs.size(); ++o) {
    const SignalRef signal{index, static_cast<int>(o), -1};
    all.emplace(block.name + "." + type.outputs[o].name, signal);
    if (o == 0 && has_one_output(type)) all.emplace(block.name, signal);
  }
  for (std::size_t s = 0; s < type.states.size(); ++s)
    all.emplace(block.name + "." + type.states[s].name, SignalRef{index, -1, static_cast<int>(s)});
}

}  // namespace

std::map<std::string, SignalRef> named_signals(const Diagram& diagram) {
  std::map<std::string, SignalRef> all;
  for (const DiagramOutput& output : diagram.outputs) all.emplace(output.name, output.signal);
  for (const PartPort& port : diagram.part_ports) all.emplace(port.name, port.signal);
  for (const DiagramBus& bus : diagram.buses)
    for (const auto& [field, signal] : bus.fields) all.emplace(bus.name + "." + field, signal);
  for (std::size_t b = 0; b < diagram.blocks.size(); ++b)
    add_signals(diagram.blocks[b], static_cast<int>(b), all);
  return all;
}

}  // namespace stepwire::diagram

#include "engine/model/diagram/unread.hpp"

#include "engine/model/diagram/external_input.hpp"
#include "engine/model/diagram/guard_types.hpp"

namespace stepwire::diagram {

namespace {

std::vector<bool> read_in(const Diagram& diagram) {
  std::vector<bool> read(diagram.blocks.size(), false);
  const auto mark = [&](int block) {
    if (block >= 0) read[static_cast<std::size_t>(block)] = true;
  };
  const auto mark_inputs = [&](const DiagramBlock& block) {
    for (const auto& sources : block.inputs)
      for (const Source& source : sources) mark(source.block);
  };
  for (const DiagramBlock& block : diagram.blocks) {
    mark(block.guard);
    if (&block.type() != &guarded_output_type()) mark_inputs(block);
  }
  for (const RecordRequest& request : diagram.records)
    for (const RecordedSignal& signal : request.signals) mark(signal.signal.block);
  for (const DiagramOutput& output : diagram.outputs) mark(output.signal.block);
  for (const PartPort& port : diagram.part_ports) mark(port.signal.block);
  for (const UnitDemand& demand : diagram.unit_demands) mark(demand.source.block);
  for (const DiagramBus& bus : diagram.buses)
    for (const auto& [name, signal] : bus.fields) mark(signal.block);
  if (diagram.stop_when)
    for (const SignalRef& signal : diagram.stop_when->variables) mark(signal.block);
  for (std::size_t b = 0; b < read.size(); ++b)  // a replacement of an output is read in its place
    if (const DiagramBlock& block = diagram.blocks[b]; read[b] && &block.type() == &guarded_output_type())
      mark_inputs(block);
  return read;
}

/// True for a block with an effect of its own, even if its outputs are not read.
bool acts(const BlockType& type) {
  return type.outputs.empty() || type.outline || type.file_output || !type.diagnostics.empty() ||
         &type == &external_input_type() || find_guard_type(type.name) == &type;
}

}  // namespace

std::vector<yaml::Fault> unread_blocks(const Diagram& diagram) {
  const std::vector<bool> read = read_in(diagram);
  std::vector<yaml::Fault> notes;
  for (std::size_t b = 0; b < diagram.blocks.size(); ++b) {
    const DiagramBlock& block = diagram.blocks[b];
    if (read[b] || block.origin.scope != 0 || acts(block.type())) continue;
    notes.push_back(diagram.fault(block.origin, block.name,
                                  "feeds nothing and is not recorded; record it, or take it out"));
  }
  return notes;
}

}  // namespace stepwire::diagram

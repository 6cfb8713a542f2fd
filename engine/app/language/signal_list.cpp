#include "engine/app/language/signal_list.hpp"

#include <algorithm>
#include <map>

#include "engine/base/yaml/document.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/output_names.hpp"

namespace stepwire::language {

namespace {

std::optional<unit::Dimension> at(const diagram::PortUnits& units, int block, int port) {
  const auto b = static_cast<std::size_t>(block), p = static_cast<std::size_t>(port);
  const bool known = block >= 0 && port >= 0 && b < units.size() && p < units[b].size();
  return known ? units[b][p] : std::nullopt;
}

std::optional<unit::Dimension> unit_of(const diagram::Diagram& diagram, const diagram::SignalRef& signal) {
  return signal.output >= 0 ? at(diagram.output_dimensions, signal.block, signal.output)
                            : at(diagram.state_dimensions, signal.block, signal.state);
}

/// Returns a name without the prefix of the file; std::nullopt for names of other files.
std::optional<std::string> local(const std::string& name, const std::string& prefix) {
  return name.starts_with(prefix) ? std::optional(name.substr(prefix.size())) : std::nullopt;
}

void add_block(const diagram::Diagram& diagram, std::size_t index, const std::string& name, bool states,
               std::vector<KnownSignal>& signals) {
  const BlockType& type = diagram.blocks[index].type();
  const int block = static_cast<int>(index);
  for (std::size_t i = 0; i < type.outputs.size(); ++i)
    signals.push_back({diagram::output_name(name, type, i),
                       at(diagram.output_dimensions, block, static_cast<int>(i)), type.name});
  for (std::size_t i = 0; states && i < type.states.size(); ++i)
    if (type.output(type.states[i].name) < 0)
      signals.push_back({name + "." + type.states[i].name,
                         at(diagram.state_dimensions, block, static_cast<int>(i)), "state of " + type.name});
}

std::optional<unit::Dimension> declared_unit(const yaml::Node& port) {
  const yaml::Node* unit = port.is_map() ? port.find("unit") : nullptr;
  const auto parsed = unit ? unit::parse_unit(unit->text) : std::nullopt;
  return parsed ? std::optional(parsed->dimension) : std::nullopt;
}

/// Adds the buses of the file and their fields; with `inside` also those within parts.
void add_buses(const Analysis& analysis, bool inside, std::vector<KnownSignal>& signals) {
  const diagram::Diagram& diagram = analysis.draft->diagram;
  for (const diagram::DiagramBus& bus : diagram.buses) {
    const auto name = local(bus.name, analysis.prefix);
    if (!name || (!inside && name->find('.') != std::string::npos)) continue;
    signals.push_back({*name, std::nullopt, "bus"});
    for (const auto& [field, signal] : bus.fields) {
      const std::string full = *name + "." + field;
      if (std::ranges::count(signals, full, &KnownSignal::name) == 0)
        signals.push_back({full, unit_of(diagram, signal), "field of a bus"});
    }
  }
}

/// Adds the outputs of the file's parts.
void add_parts(const Analysis& analysis, DiagramFiles& files, const std::string& file,
               std::vector<KnownSignal>& signals) {
  const auto tree = files.tree(file);
  const yaml::Node* blocks = tree ? tree->root.find("blocks") : nullptr;
  if (!blocks) return;
  const auto& ports = analysis.draft->diagram.part_ports;
  for (const yaml::Entry& entry : blocks->entries) {
    const std::string path = files.part_file(file, entry);
    const auto part = path.empty() ? nullptr : files.tree(path);
    const yaml::Node* outputs = part ? part->root.find("outputs") : nullptr;
    for (std::size_t i = 0; outputs && i < outputs->entries.size(); ++i) {
      const std::string name = entry.key + "." + outputs->entries[i].key;
      const auto port = std::ranges::find(ports, analysis.prefix + name, &diagram::PartPort::name);
      const auto unit = port == ports.end() ? declared_unit(outputs->entries[i].value)
                                            : unit_of(analysis.draft->diagram, port->signal);
      signals.push_back({outputs->entries.size() == 1 ? entry.key : name, unit, "part"});
    }
  }
}

void add_inputs(DiagramFiles& files, const std::string& file, std::vector<KnownSignal>& signals) {
  const auto tree = files.tree(file);
  const yaml::Node* inputs = tree ? tree->root.find("inputs") : nullptr;
  if (!inputs) return;
  for (const yaml::Entry& input : inputs->entries)
    signals.push_back({input.key, declared_unit(input.value), "input"});
}

/// True for blocks that the loader has added and that no wire can name. The guard itself is visible, because
/// its output, whether a part runs, can be read.
bool is_hidden(const BlockType& type) {
  return &type != &diagram::guard_type() && diagram::find_guard_type(type.name);
}

}  // namespace

std::vector<KnownSignal> signals_of(const Analysis& analysis, DiagramFiles& files, const std::string& file,
                                    bool inside) {
  std::vector<KnownSignal> signals;
  if (!analysis.draft) return signals;
  const diagram::Diagram& diagram = analysis.draft->diagram;
  for (std::size_t i = 0; i < diagram.blocks.size(); ++i) {
    const diagram::DiagramBlock& block = diagram.blocks[i];
    const auto name = local(block.name, analysis.prefix);
    const bool own = block.origin.scope == analysis.scope && block.type().name != "ExternalInput";
    if (name && !is_hidden(block.type()) && (own || inside)) add_block(diagram, i, *name, inside, signals);
  }
  add_parts(analysis, files, file, signals);
  add_inputs(files, file, signals);
  add_buses(analysis, inside, signals);
  return signals;
}

std::vector<KnownSignal> recorded_of(const Analysis& analysis) {
  std::vector<KnownSignal> signals{{"time", unit::parse_unit("s")->dimension, "time of the run"}};
  if (!analysis.draft) return signals;
  const diagram::Diagram& diagram = analysis.draft->diagram;
  for (const diagram::RecordRequest& request : diagram.records)
    for (const diagram::RecordedSignal& signal : request.signals)
      signals.push_back({signal.name, unit_of(diagram, signal.signal), "recorded"});
  if (diagram.sweep)
    for (const diagram::Sweep::Axis& axis : diagram.sweep->axes) {
      const diagram::DiagramParameter* parameter = parameter_of(analysis, axis.parameter);
      signals.push_back({axis.parameter, parameter ? parameter->dimension : std::nullopt, "swept"});
    }
  return signals;
}

std::optional<unit::Dimension> unit_of_input(const Analysis& analysis, const std::string& block,
                                             const std::string& key) {
  if (!analysis.draft) return std::nullopt;
  const diagram::Diagram& diagram = analysis.draft->diagram;
  const auto found = std::ranges::find(diagram.blocks, analysis.prefix + block, &diagram::DiagramBlock::name);
  if (found == diagram.blocks.end()) return std::nullopt;
  return at(analysis.draft->input_units, static_cast<int>(found - diagram.blocks.begin()),
            found->type().input(key));
}

const diagram::DiagramParameter* parameter_of(const Analysis& analysis, const std::string& name) {
  if (!analysis.draft) return nullptr;
  const auto& all = analysis.draft->diagram.parameters;
  const auto found = std::ranges::find(all, analysis.prefix + name, &diagram::DiagramParameter::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace stepwire::language

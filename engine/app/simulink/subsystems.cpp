// Subsystems that run on condition: parts with `enable` and `trigger`.
#include <fmt/format.h>

#include <algorithm>

#include "engine/app/simulink/forms.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {
namespace {

/// Returns the unit of a subsystem.
Unit& unit_of(BlockWriter& write) {
  const auto child = write.instance().children.find(&write.block());
  if (child == write.instance().children.end()) throw Untranslated("it has no content in the file");
  return *child->second->unit;
}

/// True where the outputs of a subsystem are reset while it is off. Throws Untranslated for a mixture.
bool resets_outputs(BlockWriter& write, Unit& unit) {
  std::size_t reset = 0, count = 0;
  const Model& model = write.model().model();
  for (const Block& block : write.block().system->blocks) {
    if (block.type != "Outport") continue;
    ++count;
    if (text_of(model, block, "OutputWhenDisabled", "held") == "reset") ++reset;
    const std::string initial = text_of(model, block, "InitialOutput", "[]");
    const bool has_initial = initial != "[]" && !initial.empty();
    if (has_initial && text_of(model, block, "OutputWhenDisabled", "held") != "reset")
      write.deviates(
          fmt::format("its output {} is {} before its first run in Simulink, and here what its "
                      "blocks begin with",
                      on_one_line(block.name), on_one_line(initial)));
    const auto port = static_cast<std::size_t>(port_number(model, block));
    if (port > 1000) continue;
    if (unit.safe.size() < port) unit.safe.resize(port);
    if (has_initial && initial != "0") unit.safe[port - 1] = initial;
  }
  if (reset != 0 && reset != count)
    write.deviates("holds some outputs while it is off and resets others; here all of them are reset");
  return reset != 0;
}

std::string states_of(const BlockWriter& write, const char* type, const char* parameter) {
  const Block* port = block_of_type(*write.block().system, type);
  return port ? text_of(write.model().model(), *port, parameter, "held") : "held";
}

/// Makes the key `enable`: the signal alone, or with what is reset.
yaml::Node enable_node(const std::string& when, bool resets_states, bool outputs) {
  if (!resets_states && !outputs) return word(when);
  yaml::Node node = map_of({{"when", word(when)}});
  if (resets_states) add(node, "states", word("reset"));
  if (outputs) add(node, "outputs", word("reset"));
  return node;
}

void conditional(BlockWriter& write) {
  const System& system = *write.block().system;
  Unit& unit = unit_of(write);
  write.make_part(unit.file);
  const bool outputs = resets_outputs(write, unit);
  if (block_of_type(system, "ActionPort"))
    write.key("enable", enable_node(write.source("ifaction"),
                                    states_of(write, "ActionPort", "InitializeStates") == "reset", outputs));
  if (block_of_type(system, "EnablePort"))
    write.key("enable",
              enable_node(write.source("enable"),
                          states_of(write, "EnablePort", "StatesWhenEnabling") == "reset", outputs));
  const Block* trigger = block_of_type(system, "TriggerPort");
  if (!trigger) return;
  const std::string edge = text_of(write.model().model(), *trigger, "TriggerType", "rising");
  const std::string when = write.source("trigger");
  write.key("trigger", edge == "rising" ? word(when) : map_of({{"when", word(when)}, {"edge", word(edge)}}));
}

/// Writes a Merge of parts: the output of the active one, and the last value while none is.
void merge(BlockWriter& write) {
  std::vector<yaml::Node> inputs;
  std::string formula;
  for (int i = 1; i <= write.inputs(); ++i) {
    const std::string source = write.source(i);
    const auto at = FlatModel::token_of(source);
    if (!at || write.model().blocks()[at->first].block->type != "SubSystem")
      throw Untranslated("an input of it is no subsystem that runs on condition");
    inputs.push_back(word(write.model().blocks()[at->first].name + ".active"));
    inputs.push_back(word(source));
    formula += fmt::format("u{} > 0 ? u{} : ", 2 * i - 1, 2 * i);
  }
  const std::string initial = write.text("InitialOutput", "[]");
  const Value start =
      initial == "[]" || initial.empty() ? Value::of(0.0) : write.finite("InitialOutput", "0");
  inputs.push_back(word(write.extra(
      "last", block_node("UnitDelay", {{"u", word(write.name())}, {"initial", value_node(start)}}))));
  formula += fmt::format("u{}", inputs.size());
  expression(write, formula, std::move(inputs));
}

void subsystem(BlockWriter& write) {
  const std::string obstacle = obstacle_of(write.model().model(), write.block());
  if (!obstacle.empty()) throw Untranslated("it is " + obstacle);
  conditional(write);
}

}  // namespace

std::vector<Translation> subsystem_translations() {
  return {{"SubSystem",
           "its blocks with its name before theirs; on condition a part with `enable`, `trigger`", subsystem},
          {"Merge", "`Expression` of parts and what is active", merge}};
}

}  // namespace stepwire::simulink

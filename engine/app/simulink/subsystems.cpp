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

/// Returns an output while its subsystem is off.
Rest rest_of(BlockWriter& write, const Block& outport, bool has_enable) {
  const Model& model = write.model().model();
  Rest rest;
  rest.is_reset = has_enable && text_of(model, outport, "OutputWhenDisabled", "held") == "reset";
  const std::string initial = text_of(model, outport, "InitialOutput", "[]");
  if (initial != "[]" && !initial.empty()) {
    try {
      rest.initial = write.model().evaluate(*write.instance().children.at(&write.block()), initial);
    } catch (const ValueError& error) {
      write.deviates(
          fmt::format("its output {} is {} before its first run in Simulink, which {}; here it is "
                      "what its blocks begin with",
                      on_one_line(outport.name), on_one_line(initial).substr(0, 100), error.what()));
    }
    if (rest.initial && rest.initial->cells.empty()) rest.initial.reset();
  }
  if (rest.is_reset && !rest.initial) rest.initial = Value::of(0.0);
  return rest;
}

/// Reads what the outputs of a subsystem are while it is off.
void read_rests(BlockWriter& write, Unit& unit) {
  const System& system = *write.block().system;
  const bool has_trigger = block_of_type(system, "TriggerPort"),
             has_enable = block_of_type(system, "EnablePort") || block_of_type(system, "ActionPort");
  bool are_all_reset = true, are_plain = true;
  for (const auto& [port, block] : write.instance().children.at(&write.block())->outports) {
    const Rest rest = rest_of(write, *block, has_enable);
    are_all_reset = are_all_reset && rest.is_reset;
    are_plain = are_plain && rest.initial && rest.initial->is_scalar() && !rest.initial->has_formula();
    if (rest.is_reset && has_trigger)
      write.deviates(
          fmt::format("its output {} is reset while it is disabled in Simulink, and here "
                      "between its triggers as well",
                      on_one_line(block->name)));
    if (rest.is_reset || rest.initial) unit.rests[port] = rest;
  }
  unit.resets_outputs = !unit.rests.empty() && are_all_reset && are_plain;
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
  read_rests(write, unit);
  const bool outputs = unit.resets_outputs;
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

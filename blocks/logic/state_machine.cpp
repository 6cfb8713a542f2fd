#include "blocks/logic/state_machine.hpp"

#include <fmt/format.h>

#include "blocks/logic/stage_reader.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

namespace {

Numbers outputs_of(const std::vector<Stage>& stages) {
  std::vector<double> all;
  for (const Stage& stage : stages) all.insert(all.end(), stage.output.begin(), stage.output.end());
  return Numbers(all);
}

}  // namespace

void StateMachine::declare(Declare<StateMachine>& is) {
  is.block(
      "StateMachine",
      {.doc =
           "Finite state machine. `states` is a map of name: {output: [..], to: {target: guard, ..}}. At "
           "each tick "
           "the guards of the active state are read in the order of the file, and the first that is not 0 "
           "changes "
           "the state, at most once per tick; the outputs show the new state at the same tick. A guard is a "
           "formula of u1, u2, ... (u where there is one), and `after`, the time since the state was "
           "entered: "
           "\"u1 > 5 mm && after >= 2 s\". Outputs are numbers, 0 where a state gives none. States that "
           "cannot be reached are refused."});
  is.parameter<&StateMachine::states>(
      {.doc = "the states, each with its output and transitions", .required = true});
  is.parameter<&StateMachine::initial>(
      {.doc = "name of the first state; the first of the file where left out"});
  is.input<&StateMachine::u>(
      {.unit = "*", .shape = "1", .doc = "numbers that guards read", .optional = true});
  is.output<&StateMachine::state>({.doc = "index of the active state, in the order of the file from 0"});
  is.output<&StateMachine::y>(
      {.unit = "*", .shape = "m", .doc = "output of the active state; one 0 if none gives any"});
  is.state<&StateMachine::active>({.doc = "index of the active state", .settable = false});
  is.state<&StateMachine::ticks>({.doc = "ticks since it was entered", .settable = false});
  is.clock<&StateMachine::period>();
  is.derived<&StateMachine::successor>();
  is.derived<&StateMachine::values>();
  is.derived<&StateMachine::first>();
}

void StateMachine::configure(Configure& is) {
  const auto inputs = static_cast<std::size_t>(is.count<&StateMachine::u>());
  if (inputs > max_inputs)
    is.refuse<&StateMachine::states>(fmt::format("{} inputs are more than {}", inputs, max_inputs));
  const Value tree = states.value();
  const StageReader reader(tree, inputs, [&](const std::string& message, const Value& where) {
    is.refuse<&StateMachine::states>(message, where);
  });
  const std::vector<Stage> stages = reader.read();
  const std::string wanted(initial.view());
  const std::size_t start = wanted.empty() ? 0 : reader.index_of(wanted);
  if (start == reader.none)
    is.refuse<&StateMachine::initial>("there is no state '" + wanted + "'; the states are " + reader.names());
  reader.refuse_unreachable(stages, start);
  first = static_cast<Index>(start);
  values = outputs_of(stages);
  is.size("m", static_cast<Index>(stages[0].output.size()));
  successor = successor_among(stages, inputs);
}

}  // namespace stepwire

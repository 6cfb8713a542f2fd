#include <algorithm>
#include <vector>

#include "engine/model/block/value.hpp"
#include "engine/simulate/run/faults.hpp"

namespace stepwire::run {

namespace {

/// True if a signal follows from the outputs of a block, through any number of other blocks.
bool follows_from(const plan::Plan& plan, const std::vector<diagram::Source>& sources, std::size_t block) {
  std::vector<bool> seen(plan.blocks.size(), false);
  std::vector<std::size_t> open;
  const auto add = [&](const std::vector<diagram::Source>& from) {
    for (const diagram::Source& source : from)
      if (source.block >= 0 && !seen[static_cast<std::size_t>(source.block)]) {
        seen[static_cast<std::size_t>(source.block)] = true;
        open.push_back(static_cast<std::size_t>(source.block));
      }
  };
  add(sources);
  while (!open.empty()) {
    const std::size_t next = open.back();
    open.pop_back();
    for (const auto& inputs : plan.diagram.blocks[next].inputs) add(inputs);
  }
  return seen[block];
}

/// True if a reset acts where its signal becomes true.
bool acts_once_true(const diagram::DiagramBlock& block) {
  for (const ParameterSpec& spec : block.type().parameters)
    if (spec.name == "trigger") {
      const Value value = spec.get(block.block.get());
      const auto* const index = std::get_if<double>(&value.content);
      if (!index) return false;
      const std::string& word = spec.words.at(static_cast<std::size_t>(*index));
      return word == "rising" || word == "either";
    }
  return false;
}

/// Returns the number of a block's state or signal of one element; 0 without one.
double number_of(const std::vector<plan::SignalSlot>& slots, const double* values) {
  return slots.size() == 1 && slots.front().size == 1 ? values[slots.front().offset] : 0.0;
}

}  // namespace

std::vector<RaisedDiagnostic> notes_on_held_resets(const plan::Plan& plan, const double* values) {
  std::vector<RaisedDiagnostic> notes;
  if (plan.diagram.events.locate) return notes;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const diagram::DiagramBlock& block = plan.diagram.blocks[b];
    const int reset = block.type().input("reset"), side = block.type().state("side");
    if (reset < 0 || side < 0 || !block.type().has_continuous_state() || !acts_once_true(block)) continue;
    const auto& sources = block.inputs[static_cast<std::size_t>(reset)];
    const auto& slots = plan.blocks[b].inputs[static_cast<std::size_t>(reset)];
    const plan::SignalSlot& last = plan.blocks[b].states[static_cast<std::size_t>(side)];
    if (!(number_of(slots, values) > 0.0) || !(values[last.offset] > 0.0) || !follows_from(plan, sources, b))
      continue;
    notes.push_back({block.name,
                     "its reset follows from its own state and is still true at the end, so it does not act "
                     "again; 'events: locate' resets at the crossing itself, before the state goes beyond",
                     values[plan::Layout::time]});
  }
  return notes;
}

}  // namespace stepwire::run

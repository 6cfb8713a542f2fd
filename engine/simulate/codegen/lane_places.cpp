#include "engine/simulate/codegen/lane_places.hpp"

#include "engine/simulate/solve/solver.hpp"

namespace stepwire::codegen {

namespace {

class Follower {
 public:
  Follower(const plan::Plan& plan, int lanes)
      : plan_(plan),
        result_{lanes, std::vector<bool>(plan.layout.size), std::vector<bool>(plan.blocks.size())} {}

  void add(const plan::RunDifferences& differences) {
    for (const plan::VariableBlock& variable : differences.variable) mark_block(variable.block);
    for (const diagram::Target& target : differences.values) {
      const auto block = static_cast<std::size_t>(target.block);
      if (target.kind != diagram::Target::Kind::constant)
        mark_block(block);
      else
        mark(plan_.blocks[block].inputs[static_cast<std::size_t>(target.index)]);
    }
  }

  LanePlaces take() {
    while (std::exchange(changed_, false))
      for (std::size_t b = 0; b < plan_.blocks.size(); ++b)
        if (!result_.blocks[b] && differs(b)) mark_block(b);
    return std::move(result_);
  }

 private:
  void mark_block(std::size_t index) {
    const plan::PlannedBlock& block = plan_.blocks[index];
    result_.blocks[index] = changed_ = true;
    for (const auto* slots : {&block.outputs, &block.states, &block.diagnostics}) mark(*slots);
    const BlockType& type = plan_.diagram.blocks[index].type();
    for (std::size_t s = 0; s < block.states.size(); ++s)
      if (type.states[s].continuous) mark({block.derivatives[s]});
  }

  void mark(const std::vector<plan::SignalSlot>& slots) {
    for (const plan::SignalSlot& slot : slots)
      for (std::size_t i = slot.offset; i < slot.offset + static_cast<std::size_t>(slot.size); ++i)
        result_.places[i] = true;
  }

  bool any(const std::vector<plan::SignalSlot>& slots) const {
    for (const plan::SignalSlot& slot : slots)
      for (std::size_t i = slot.offset; i < slot.offset + static_cast<std::size_t>(slot.size); ++i)
        if (result_.places[i]) return true;
    return false;
  }

  /// True if a block reads a number that differs between lanes. Also true if it writes to a place that
  /// differs because of another block, such as the derivative of a state.
  bool differs(std::size_t index) const {
    const plan::PlannedBlock& block = plan_.blocks[index];
    for (const auto& slots : block.inputs)
      if (any(slots)) return true;
    return any(block.outputs) || any(block.states);
  }

  const plan::Plan& plan_;
  LanePlaces result_;
  bool changed_ = true;
};

}  // namespace

std::vector<LanePlaces::Stretch> LanePlaces::stretches(std::size_t first, std::size_t end) const {
  std::vector<Stretch> result;
  for (std::size_t i = first; i < end; ++i)
    if (!result.empty() && result.back().differs == places[i])
      ++result.back().end;
    else
      result.push_back({i, i + 1, places[i]});
  return result;
}

LanePlaces lane_places(const plan::Plan& plan, const plan::RunDifferences& differences, int lanes) {
  Follower follower(plan, lanes);
  follower.add(differences);
  return follower.take();
}

std::string why_not_in_lanes(const plan::Plan& plan) {
  if (!plan.guards.empty()) return "blocks of it run on condition";
  if (!plan.loops.empty()) return "it has algebraic loops";
  if (!plan.late.empty()) return "resets of it read the states of each other";
  if (plan.crossing_count > 0) return "its events are located";
  if (solve::find_called(plan.diagram.solver, plan.diagram.error_control.has_value()))
    return plan.diagram.error_control ? "its solver chooses its steps" : "its solver is implicit";
  return "";
}

}  // namespace stepwire::codegen

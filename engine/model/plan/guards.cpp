#include "engine/model/plan/guards.hpp"

#include <algorithm>

#include "engine/model/diagram/guard.hpp"
#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

namespace {

/// Appends a copy, or extends the last one by an adjacent range.
void append(std::vector<Copied>& pieces, const SignalSlot& from, const SignalSlot& to) {
  const auto size = static_cast<std::size_t>(to.size);
  if (!pieces.empty() && pieces.back().from + pieces.back().size == from.offset &&
      pieces.back().to + pieces.back().size == to.offset)
    pieces.back().size += size;
  else if (size > 0)
    pieces.push_back({from.offset, to.offset, size});
}

void append(std::vector<SignalSlot>& pieces, const SignalSlot& slot) {
  if (!pieces.empty() && pieces.back().offset + static_cast<std::size_t>(pieces.back().size) == slot.offset)
    pieces.back().size += slot.size;
  else if (slot.size > 0)
    pieces.push_back(slot);
}

class GuardMaker {
 public:
  explicit GuardMaker(Draft& draft) : draft_(draft), plan_(draft.plan), index_(draft.blocks.size(), -1) {}

  void run() {
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b) add(b);
    for (const int b : plan_.memory_order) {
      const auto block = static_cast<std::size_t>(b);
      const auto guards = guards_of(plan_.diagram, block);
      if (guards.empty()) continue;
      add_own(block, of(guards.front()));
      for (const int guard : guards)
        if (resets(plan_.diagram, guard)) add_reset(block, of(guard));
    }
  }

 private:
  PlannedGuard& of(int block) {
    return plan_.guards[static_cast<std::size_t>(index_[static_cast<std::size_t>(block)])];
  }

  /// Adds a guard after the one that encloses it.
  void add(std::size_t block) {
    const diagram::DiagramBlock& from = plan_.diagram.blocks[block];
    if (&from.type() != &diagram::guard_type() || index_[block] >= 0) return;
    if (from.guard >= 0) add(static_cast<std::size_t>(from.guard));
    index_[block] = static_cast<int>(plan_.guards.size());
    PlannedGuard& made = plan_.guards.emplace_back();
    made.block = block;
    made.active = plan_.blocks[block].outputs.front().offset;
    made.once_per_edge =
        !from.inputs[static_cast<std::size_t>(diagram::guard_type().input("trigger"))].empty();
    if (from.guard >= 0) of(from.guard).inside.push_back(index_[block]);
  }

  /// Adds what the guard keeps while it is active: outputs, and the time for a state that is named `seen_at`.
  /// The time is not restored.
  void add_own(std::size_t block, PlannedGuard& guard) {
    const PlannedBlock& planned = plan_.blocks[block];
    for (std::size_t o = 0; o < planned.kept.size(); ++o)
      append(guard.keep, planned.outputs[o], planned.kept[o]);
    const int seen = draft_.type(block).state("seen_at");
    if (seen >= 0 && draft_.blocks[block].updates_at_events)
      append(guard.keep, {Layout::time}, planned.states[static_cast<std::size_t>(seen)]);
    for (std::size_t s = 0; s < planned.derivatives.size(); ++s)
      if (draft_.type(block).states[s].continuous) append(guard.slopes, planned.derivatives[s]);
  }

  /// Adds the reset of a block's states. A block with constant outputs is computed only once, so its start()
  /// must not change them again.
  void add_reset(std::size_t block, PlannedGuard& guard) {
    const PlannedBlock& planned = plan_.blocks[block];
    for (std::size_t s = 0; s < planned.initial.size(); ++s)
      append(guard.reset, planned.initial[s], planned.states[s]);
    if (draft_.type(block).start && planned.rate.kind != Rate::Kind::constant) guard.start.push_back(block);
  }

  Draft& draft_;
  Plan& plan_;
  std::vector<int> index_;  ///< index in Plan::guards of each block; -1 for other blocks
};

}  // namespace

std::vector<int> guards_of(const diagram::Diagram& diagram, std::size_t block) {
  std::vector<int> guards;
  for (int guard = diagram.blocks[block].guard; guard >= 0;
       guard = diagram.blocks[static_cast<std::size_t>(guard)].guard)
    guards.push_back(guard);
  return guards;
}

bool resets(const diagram::Diagram& diagram, int guard) {
  const void* block = diagram.blocks[static_cast<std::size_t>(guard)].block.get();
  return static_cast<const diagram::Guard*>(block)->states == diagram::Guard::States::reset;
}

bool is_reset(const diagram::Diagram& diagram, std::size_t block) {
  return std::ranges::any_of(guards_of(diagram, block), [&](int guard) { return resets(diagram, guard); });
}

void plan_guards(Draft& draft) {
  GuardMaker(draft).run();
}

}  // namespace stepwire::plan

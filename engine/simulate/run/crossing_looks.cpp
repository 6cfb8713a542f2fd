#include "engine/simulate/run/crossing_looks.hpp"

#include <algorithm>
#include <limits>

#include "engine/model/plan/active.hpp"
#include "engine/model/plan/run_ends.hpp"
#include "engine/model/signal/diagnostic.hpp"

namespace stepwire::run {

namespace {

void mark(const plan::SignalSlot& slot, std::vector<bool>& marked) {
  std::fill_n(marked.begin() + static_cast<std::ptrdiff_t>(slot.offset), slot.size, true);
}

/// Flags the numbers of the workspace that only the solver and time change, and those that never change.
std::vector<bool> settled_numbers(const plan::Plan& plan) {
  const plan::Layout& layout = plan.layout;
  std::vector<bool> settled(layout.size, false);
  const auto fill = [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) settled[i] = true;
  };
  fill(plan::Layout::time, plan::Layout::time + 1);
  fill(layout.constants, layout.report);
  fill(layout.states, layout.derivatives);
  for (const auto* table : {&plan.once, &plan.timed, &plan.ahead})
    for (const plan::KernelCall& call : *table)
      for (const plan::PlannedBlock& block : plan.blocks)
        if (block.memory >= call.first && block.memory < call.end)
          for (const plan::SignalSlot& slot : block.outputs) mark(slot, settled);
  return settled;
}

}  // namespace

CrossingLooks::CrossingLooks(BoundBlocks& blocks)
    : plan_(blocks.plan()),
      blocks_(blocks),
      values_(blocks.values()),
      ends_(plan::places_of_ends(plan_, false)),
      faults_(plan::places_of_ends(plan_, true)),
      may_stop_(plan::may_end_between(plan_)) {
  for (const std::size_t block : plan_.edges)
    edges_.push_back({plan_.diagram.blocks[block].type().run_next_edge, blocks.memory(block)});
  const std::vector<bool> settled = settled_numbers(plan_);
  for (const plan::CrossingCall& call : plan_.crossings) add(call, settled);
  if (plan_.stop_crossing) add_stop(settled);
}

void CrossingLooks::add(const plan::CrossingCall& call, const std::vector<bool>& settled) {
  static constexpr double always = 1.0;
  const BlockType& type = plan_.diagram.blocks[call.block].type();
  const std::ptrdiff_t active = plan::active_of(plan_, call.block);
  looks_.push_back({type.run_crossings, blocks_.memory(call.block), active < 0 ? &always : values_ + active,
                    call.first, call.count});
  guarded_ |= active >= 0;
  const auto changes = [&](const CrossingSpec& spec) {
    return std::ranges::any_of(spec.inputs, [&](const std::string& input) {
      const auto& slots = plan_.blocks[call.block].inputs[static_cast<std::size_t>(type.input(input))];
      return std::ranges::any_of(slots, [&](const plan::SignalSlot& slot) { return !settled[slot.offset]; });
    });
  };
  const auto remembers = [](const StateSpec& state) { return !state.continuous; };
  if (active >= 0 || std::ranges::any_of(type.crossings, changes) ||
      std::ranges::any_of(type.states, remembers))
    changing_.push_back(looks_.back());
}

void CrossingLooks::add_stop(const std::vector<bool>& settled) {
  stop_margin_.emplace(plan_);
  stop_changes_ =
      std::ranges::any_of(stop_offsets(plan_), [&](std::size_t place) { return !settled[place]; });
}

void CrossingLooks::find(const std::vector<Look>& looks, double* numbers) {
  for (const Look& look : looks) {
    if (*look.active == 0.0)
      std::fill_n(numbers + look.first, look.count, 0.0);
    else
      look.run(look.block, numbers + look.first);
  }
}

bool CrossingLooks::stops() const {
  const double now = values_[plan::Layout::time];
  return (stop_margin_ && stop_margin_->stops(values_)) ||
         std::ranges::any_of(ends_, [&](std::size_t place) { return values_[place] <= now; }) ||
         std::ranges::any_of(faults_, [&](std::size_t place) { return values_[place] == now; });
}

void CrossingLooks::find_all(double* numbers) const {
  find(looks_, numbers);
  if (stop_margin_) numbers[*plan_.stop_crossing] = (*stop_margin_)(values_);
}

double CrossingLooks::earliest_edge() const {
  double next = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_) next = std::min(next, edge.next(edge.block));
  for (const std::size_t place : ends_)
    if (values_[place] > values_[plan::Layout::time]) next = std::min(next, values_[place]);
  return next;
}

}  // namespace stepwire::run

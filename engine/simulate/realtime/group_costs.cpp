#include "engine/simulate/realtime/group_costs.hpp"

#include <algorithm>
#include <limits>

namespace stepwire::realtime {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Returns the type of the block at this offset of the memory of blocks.
const BlockType& type_at(const plan::Plan& plan, std::size_t memory) {
  const auto found = std::lower_bound(plan.memory_order.begin(), plan.memory_order.end(), memory,
                                      [&](int block, std::size_t offset) {
                                        return plan.blocks[static_cast<std::size_t>(block)].memory < offset;
                                      });
  return plan.diagram.blocks[static_cast<std::size_t>(*found)].type();
}

}  // namespace

GroupCosts::GroupCosts(const plan::Plan& plan, LoopClock& clock)
    : clock_(clock), stretches_{{&plan.outputs, 0, 0, none}} {
  for (const auto* phase : {&plan.timed, &plan.outputs, &plan.updates, &plan.stage, &plan.derivatives})
    cut(plan, *phase);
  for (GroupCost& group : groups_)
    group.blocks = static_cast<std::size_t>(
        std::count_if(plan.diagram.blocks.begin(), plan.diagram.blocks.end(),
                      [&](const diagram::DiagramBlock& block) { return block.type().name == group.type; }));
}

void GroupCosts::cut(const plan::Plan& plan, const std::vector<plan::KernelCall>& phase) {
  for (std::size_t i = 0; i < phase.size(); ++i) {
    const std::string& type = type_at(plan, phase[i].first).name;
    const bool goes_on = i > 0 && groups_[stretches_.back().group].type == type;
    if (goes_on) {
      stretches_.back().end = i + 1;
      continue;
    }
    const auto known = std::find_if(groups_.begin(), groups_.end(),
                                    [&](const GroupCost& group) { return group.type == type; });
    const auto group = static_cast<std::size_t>(known - groups_.begin());
    if (known == groups_.end()) groups_.push_back({type, 0, 0.0, 0});
    stretches_.push_back({&phase, i, i + 1, group});
  }
}

void GroupCosts::before_tick(run::Executor& simulation) {
  sequence_ = sequence_ * 6364136223846793005u + 1442695040888963407u;  // Knuth's generator
  now_ = &stretches_[static_cast<std::size_t>((sequence_ >> 33) % stretches_.size())];
  phase = now_->phase;
  first = now_->first;
  end = now_->end;
  ran_ = false;
  simulation.watch(this);
}

void GroupCosts::after_tick(run::Executor& simulation) {
  if (ran_) now_->samples.add();
  simulation.watch(nullptr);
}

void GroupCosts::enter() {
  entered_ = clock_.now();
}

void GroupCosts::leave() {
  now_->spent.add(clock_.now() - entered_);
  now_->looks.add();
  ran_ = true;
}

double GroupCosts::cost_of_look() const {
  const Stretch& empty = stretches_.front();
  return empty.looks > 0 ? static_cast<double>(empty.spent.get()) / static_cast<double>(empty.looks.get())
                         : 0.0;
}

std::vector<GroupCost> GroupCosts::costs() const {
  std::vector<GroupCost> costs = groups_;
  for (const Stretch& stretch : stretches_) {
    if (stretch.samples == 0 || stretch.group == none) continue;
    const double spent =
        static_cast<double>(stretch.spent.get()) - cost_of_look() * static_cast<double>(stretch.looks.get());
    costs[stretch.group].samples += stretch.samples;
    costs[stretch.group].mean += std::max(0.0, spent) / static_cast<double>(stretch.samples.get());
  }
  std::stable_sort(costs.begin(), costs.end(),
                   [](const GroupCost& a, const GroupCost& b) { return a.mean > b.mean; });
  return costs;
}

}  // namespace stepwire::realtime

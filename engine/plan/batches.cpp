#include <algorithm>

#include "engine/plan/draft.hpp"

namespace stepwire {

namespace {

int period_index(Plan& plan, std::int64_t ticks) {
  const auto found = std::find(plan.periods.begin(), plan.periods.end(), ticks);
  if (found == plan.periods.end()) plan.periods.push_back(ticks);
  return static_cast<int>(std::find(plan.periods.begin(), plan.periods.end(), ticks) - plan.periods.begin());
}

/// Appends a call, or lengthens the last one where the block lies right behind.
void append(std::vector<Batch>& batches, Plan& plan, std::size_t block, Kernel kernel) {
  const std::size_t bytes = plan.diagram.blocks[block].type().bytes;
  const std::size_t memory = plan.blocks[block].memory;
  const int period = period_index(plan, plan.blocks[block].rate.ticks);
  if (!batches.empty()) {
    Batch& last = batches.back();
    if (last.run == kernel && last.period == period && last.first + last.count * bytes == memory) {
      ++last.count;
      return;
    }
  }
  batches.push_back({kernel, memory, 1, period});
}

}  // namespace

void plan_batches(Draft& draft, const std::vector<int>& order) {
  Plan& plan = draft.plan;
  plan.periods = {1};
  for (int b : order) {
    const auto block = static_cast<std::size_t>(b);
    const Kernel kernel = draft.type(block).run_outputs;
    if (plan.blocks[block].rate.kind == Rate::Kind::constant) {
      append(plan.once, plan, block, kernel);
    } else {
      append(plan.outputs, plan, block, kernel);
      if (draft.blocks[block].in_stages) append(plan.stage, plan, block, kernel);
    }
  }
  // Updates of continuous states come last: a discrete block that reads such a state still sees its value at
  // the tick.
  for (const bool continuous : {false, true})
    for (int b : plan.memory_order) {
      const auto block = static_cast<std::size_t>(b);
      const BlockType& type = draft.type(block);
      if (type.run_derivatives && !continuous) append(plan.derivatives, plan, block, type.run_derivatives);
      if (!draft.blocks[block].updates || type.has_continuous_state() != continuous) continue;
      append(plan.updates, plan, block, type.run_update);
      plan.updates_continuous = plan.updates_continuous || continuous;
    }
}

}  // namespace stepwire

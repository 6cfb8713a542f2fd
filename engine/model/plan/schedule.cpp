#include <algorithm>

#include "engine/model/plan/draft.hpp"

namespace stepwire {

namespace {

int period_index(Plan& plan, std::int64_t ticks) {
  const auto found = std::find(plan.periods.begin(), plan.periods.end(), ticks);
  if (found == plan.periods.end()) plan.periods.push_back(ticks);
  return static_cast<int>(std::find(plan.periods.begin(), plan.periods.end(), ticks) - plan.periods.begin());
}

bool has_one_element_each(const Draft::Block& block) {
  const auto all_one = [](const std::vector<Eigen::Index>& sizes) {
    return std::all_of(sizes.begin(), sizes.end(), [](Eigen::Index size) { return size == 1; });
  };
  return all_one(block.output_sizes) && all_one(block.state_sizes) && all_one(block.input_sizes);
}

/// What is known of a block beyond its type.
Known known_of(const Draft& draft, std::size_t block) {
  if (!has_one_element_each(draft.blocks[block])) return Known::nothing;
  if (!draft.blocks[block].says.slope_source.first.empty()) return Known::plain_slope;
  const int list = draft.type(block).input("u");
  if (list < 0) return Known::one_element;
  switch (draft.plan.diagram.blocks[block].inputs[static_cast<std::size_t>(list)].size()) {
    case 0:
      return Known::nothing;  // what is not fed is empty
    case 2:
      return Known::two_in_list;
    case 3:
      return Known::three_in_list;
    default:
      return Known::one_element;
  }
}

/// The kernel that takes the most for granted of what is true of a block.
Kernel kernel_of(const Draft& draft, std::size_t block, const Kernels& kernels) {
  const Known known = known_of(draft, block);
  return known == Known::nothing || kernels[known] ? kernels[known] : kernels[Known::one_element];
}

/// Appends a call, or lengthens the last one where the block lies right behind.
void append(std::vector<KernelCall>& batches, const Draft& draft, std::size_t block, const Kernels& kernels) {
  Plan& plan = draft.plan;
  const Kernel kernel = kernel_of(draft, block, kernels);
  const std::size_t bytes = draft.type(block).bytes, memory = plan.blocks[block].memory;
  const int period = period_index(plan, plan.blocks[block].rate.ticks);
  if (!batches.empty()) {
    KernelCall& last = batches.back();
    if (last.run == kernel && last.period == period && last.end == memory) {
      ++last.count;
      last.end += bytes;
      return;
    }
  }
  batches.push_back({kernel, memory, memory + bytes, 1, period});
}

}  // namespace

void make_schedule(Draft& draft, const std::vector<int>& order) {
  Plan& plan = draft.plan;
  plan.periods = {1};
  for (int b : order) {
    const auto block = static_cast<std::size_t>(b);
    const Kernels& kernels = draft.type(block).run_outputs;
    if (plan.blocks[block].rate.kind == Rate::Kind::constant) {
      append(plan.once, draft, block, kernels);
    } else if (draft.blocks[block].timed) {
      append(plan.timed, draft, block, kernels);
    } else {
      append(plan.outputs, draft, block, kernels);
      if (draft.blocks[block].in_stages) append(plan.stage, draft, block, kernels);
    }
  }
  // Updates of continuous states come last: a discrete block that reads such a state still sees its value at
  // the tick.
  for (const bool continuous : {false, true})
    for (int b : plan.memory_order) {
      const auto block = static_cast<std::size_t>(b);
      const BlockType& type = draft.type(block);
      if (type.run_derivatives && !continuous && !plan.blocks[block].slope_is_input)
        append(plan.derivatives, draft, block, type.run_derivatives);
      if (!draft.blocks[block].updates || type.has_continuous_state() != continuous) continue;
      append(plan.updates, draft, block, type.run_update);
      plan.updates_continuous = plan.updates_continuous || continuous;
    }
}

}  // namespace stepwire

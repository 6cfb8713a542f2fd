#include <algorithm>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

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
Specialization specialization_of(const Draft& draft, std::size_t block) {
  if (!has_one_element_each(draft.blocks[block])) return Specialization::nothing;
  if (!draft.blocks[block].says.slope_source.first.empty()) return Specialization::plain_slope;
  const int list = draft.type(block).input("u");
  if (list < 0) return Specialization::one_element;
  switch (draft.plan.diagram.blocks[block].inputs[static_cast<std::size_t>(list)].size()) {
    case 0:
      return Specialization::nothing;  // what is not fed is empty
    case 2:
      return Specialization::two_in_list;
    case 3:
      return Specialization::three_in_list;
    default:
      return Specialization::one_element;
  }
}

/// The kernel that takes the most for granted of what is true of a block.
Kernel kernel_of(const Draft& draft, std::size_t block, const Kernels& kernels) {
  const Specialization specialization = specialization_of(draft, block);
  return specialization == Specialization::nothing || kernels[specialization]
             ? kernels[specialization]
             : kernels[Specialization::one_element];
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

void append_outputs(Draft& draft, std::size_t block) {
  Plan& plan = draft.plan;
  const Kernels& kernels = draft.type(block).run_outputs;
  if (plan.blocks[block].rate.kind == Rate::Kind::constant) return append(plan.once, draft, block, kernels);
  if (draft.blocks[block].timed) return append(plan.timed, draft, block, kernels);
  append(plan.outputs, draft, block, kernels);
  if (draft.blocks[block].in_stages) append(plan.stage, draft, block, kernels);
}

void append_derivatives(Draft& draft, std::size_t block) {
  const BlockType& type = draft.type(block);
  if (type.run_derivatives && !draft.plan.blocks[block].slope_is_input)
    append(draft.plan.derivatives, draft, block, type.run_derivatives);
}

void append_updates(Draft& draft, std::size_t block) {
  if (!draft.blocks[block].updates) return;
  const BlockType& type = draft.type(block);
  append(draft.plan.updates, draft, block, type.run_update);
  draft.plan.updates_continuous = draft.plan.updates_continuous || type.has_continuous_state();
}

}  // namespace

void make_schedule(Draft& draft, const std::vector<int>& order) {
  draft.plan.periods = {1};
  for (int block : order) append_outputs(draft, static_cast<std::size_t>(block));
  // Updates of continuous states come last: a discrete block that reads such a state still sees its value at
  // the tick.
  for (const bool continuous : {false, true})
    for (int b : draft.plan.memory_order) {
      const auto block = static_cast<std::size_t>(b);
      if (!continuous) append_derivatives(draft, block);
      if (draft.type(block).has_continuous_state() == continuous) append_updates(draft, block);
    }
}

}  // namespace stepwire::plan

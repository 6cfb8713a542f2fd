#include "engine/simulate/codegen/stage_places.hpp"

#include <algorithm>

namespace stepwire::codegen {

namespace {

bool is_in(const plan::KernelCall& batch, const plan::Plan& plan, const plan::PlannedBlock& block) {
  const auto index = static_cast<std::size_t>(&block - plan.blocks.data());
  const Kernels& kernels = plan.diagram.blocks[index].type().run_outputs;
  return block.memory >= batch.first && block.memory < batch.end && kernels.contains(batch.run);
}

}  // namespace

Places stage_places(const plan::Plan& plan, Places places) {
  places.fresh = "s";
  places.is_fresh.assign(plan.layout.derivatives + plan.layout.state_count, false);
  places.is_fresh[plan::Layout::time] = true;
  for (std::size_t i = plan.layout.states; i < plan.layout.derivatives; ++i) places.is_fresh[i] = true;
  for (const plan::KernelCall& batch : plan.stage)
    for (const plan::PlannedBlock& block : plan.blocks)
      if (batch.active < 0 && is_in(batch, plan, block))
        for (const plan::SignalSlot& slot : block.outputs)
          std::fill_n(places.is_fresh.begin() + static_cast<std::ptrdiff_t>(slot.offset), slot.size, true);
  return places;
}

std::size_t count_of(const std::vector<plan::KernelCall>& batches) {
  std::size_t count = 0;
  for (const plan::KernelCall& batch : batches) count += batch.count;
  return count;
}

}  // namespace stepwire::codegen

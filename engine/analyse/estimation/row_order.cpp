#include "engine/analyse/estimation/row_order.hpp"

#include <algorithm>

namespace stepwire::estimation {

namespace {

/// True for a block with a state and an input. A source may have a state, too, e.g. that of a random number.
bool has_memory(const plan::PlannedBlock& block) {
  return std::ranges::any_of(block.states, [](const plan::SignalSlot& state) { return state.size > 0; }) &&
         std::ranges::any_of(block.inputs, [](const auto& port) { return !port.empty(); });
}

}  // namespace

bool in_time(const plan::Plan& plan, const FitRequest& request) {
  return request.standard_errors == StandardErrors::serial || std::ranges::any_of(plan.blocks, has_memory);
}

StandardErrors used_errors(const FitRequest& request, bool in_time) {
  if (request.standard_errors != StandardErrors::automatic) return request.standard_errors;
  return in_time ? StandardErrors::serial : StandardErrors::classical;
}

}  // namespace stepwire::estimation

#pragma once

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// Returns the workspace index of the guard output that activates a block; -1 for a block that is always
/// active or computed only once.
inline std::ptrdiff_t active_of(const Plan& plan, std::size_t block) {
  const int guard = plan.diagram.blocks[block].guard;
  if (guard < 0 || plan.blocks[block].rate.kind == Rate::Kind::constant) return -1;
  return static_cast<std::ptrdiff_t>(plan.blocks[static_cast<std::size_t>(guard)].outputs.front().offset);
}

}  // namespace stepwire::plan

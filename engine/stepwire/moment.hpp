#pragma once

#include <cstdint>
#include <vector>

#include "engine/simulate/run/executor.hpp"
#include "engine/stepwire/snapshot.hpp"

namespace stepwire {

struct Snapshot::Content {
  const plan::Plan* plan = nullptr;
  run::Workspace workspace{};   ///< between two ticks
  std::vector<double> shown{};  ///< the numbers of the tick before, where a step has been made
  std::int64_t shown_tick = 0;
  bool ended = false;
};

/// Throws std::logic_error for a moment of a run of another plan.
void check_plan(const Snapshot& snapshot, const plan::Plan& plan);

}  // namespace stepwire

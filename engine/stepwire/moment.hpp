#pragma once

#include <cstdint>
#include <vector>

#include "engine/simulate/run/executor.hpp"
#include "engine/stepwire/snapshot.hpp"

namespace stepwire {

struct Snapshot::Content {
  const plan::Plan* plan = nullptr;
  run::Workspace workspace{};   ///< state between two ticks
  std::vector<double> shown{};  ///< numbers of the last tick, after a step
  std::int64_t shown_tick = 0;
  bool ended = false;
};

/// Throws std::logic_error for a snapshot of a run of another plan.
void check_plan(const Snapshot& snapshot, const plan::Plan& plan);

}  // namespace stepwire

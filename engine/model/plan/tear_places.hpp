#pragma once

#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// Place of the numbers of a torn signal in the workspace, and that of their residuals.
struct TearPlace {
  std::size_t offset, size, residual;
};

/// Returns the torn signals of all solved loops.
inline std::vector<TearPlace> tear_places(const Plan& plan) {
  std::vector<TearPlace> places;
  for (const SolvedLoop& loop : plan.loops) {
    std::size_t residual = loop.residuals;
    for (const diagram::SignalRef& tear : loop.tears) {
      const SignalSlot& slot = plan.slot(tear);
      const auto size = static_cast<std::size_t>(slot.size);
      places.push_back({slot.offset, size, residual});
      residual += size;
    }
  }
  return places;
}

}  // namespace stepwire::plan

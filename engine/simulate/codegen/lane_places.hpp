#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::codegen {

/// What differs between the runs that generated code steps together, in so many lanes. All else is computed
/// once, in lane 0.
struct LanePlaces {
  int lanes = 1;             ///< 1: code for one run
  std::vector<bool> places;  ///< numbers of the workspace
  std::vector<bool> blocks;

  /// A stretch of the workspace that lies in each lane, or in lane 0 for all.
  struct Stretch {
    std::size_t first, end;
    bool differs;
  };
  /// From `first` to `end - 1`.
  std::vector<Stretch> stretches(std::size_t first, std::size_t end) const;
};

/// Follows from the blocks and values that differ along all wires.
LanePlaces lane_places(const plan::Plan& plan, const plan::RunDifferences& differences, int lanes);

/// Why the runs of a plan are not stepped together: a sentence; empty where they may be.
std::string why_not_in_lanes(const plan::Plan& plan);

/// " in lane l", as code: what stands behind the name of numbers of all lanes; nothing in code for one run.
inline std::string lane_text(const LanePlaces& lanes, bool differs) {
  if (lanes.lanes == 1) return "";
  return differs ? ".lane(l)" : ".lane(0)";
}

}  // namespace stepwire::codegen

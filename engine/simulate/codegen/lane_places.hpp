#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::codegen {

/// Numbers and blocks that differ between the runs of a lane group. All others are computed once, in lane 0.
struct LanePlaces {
  int lanes = 1;             ///< 1 for code of one run
  std::vector<bool> places;  ///< numbers of the workspace that differ
  std::vector<bool> blocks;

  /// Range of the workspace that is stored in each lane, or in lane 0 for all.
  struct Stretch {
    std::size_t first, end;
    bool differs;
  };
  /// Returns the ranges in [first, end).
  std::vector<Stretch> stretches(std::size_t first, std::size_t end) const;
};

/// Propagates the differences of blocks and values along all wires.
LanePlaces lane_places(const plan::Plan& plan, const plan::RunDifferences& differences, int lanes);

/// Returns the reason why the runs of a plan cannot use lanes, as a sentence; an empty text without one.
std::string why_not_in_lanes(const plan::Plan& plan);

/// Returns the C++ suffix that selects the lane of a number; an empty text in code for one run.
inline std::string lane_text(const LanePlaces& lanes, bool differs) {
  if (lanes.lanes == 1) return "";
  return differs ? ".lane(l)" : ".lane(0)";
}

/// Returns the function that steps several runs, which uses evaluate() and advance() of the program. It
/// checks for non-finite numbers and ends of runs, and writes the recorded rows. `workspace` declares `w`
/// from the task; `begin` precedes each step.
std::string lane_steps_text(const plan::Plan& plan, const LanePlaces& lanes, const std::string& workspace,
                            const std::string& begin);

}  // namespace stepwire::codegen

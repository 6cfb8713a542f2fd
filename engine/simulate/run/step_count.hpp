#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// Step counts of a solver with error control.
struct StepCount {
  std::int64_t accepted = 0, rejected = 0;
  double largest_error = 0.0;  ///< of the accepted steps, relative to the tolerance
  bool stiff = false;          ///< true if `auto` has switched to the stiff method

  StepCount& operator+=(const StepCount& other) {
    accepted += other.accepted;
    rejected += other.rejected;
    largest_error = std::max(largest_error, other.largest_error);
    stiff = stiff || other.stiff;
    return *this;
  }
};

/// Returns the counts of a run up to now, from the numbers of its workspace.
StepCount step_count(const plan::Plan& plan, const double* values);

}  // namespace stepwire::run

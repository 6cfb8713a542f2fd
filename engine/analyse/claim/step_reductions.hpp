#pragma once

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/reduce.hpp"

namespace stepwire::claim {

/// True for overshoot, rise_time, settling_time, peak_time, iae and steady_error, which are defined for one
/// run.
bool is_of_step(Reduction reduction);

/// Computes such a number from the selected rows of one run; at least one must be selected. Definitions are
/// those of stepinfo in MATLAB. The first selected row is the initial value, the last one the final value.
/// Times count from the first row and are interpolated linearly. Returns nan if the signal ends at its
/// initial value, or if a value is nan.
double reduce_step(Reduction reduction, const Rows& rows);

}  // namespace stepwire::claim

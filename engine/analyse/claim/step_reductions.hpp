#pragma once

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/reduce.hpp"

namespace stepwire::claim {

/// Is it one of overshoot, rise_time, settling_time, peak_time, iae and steady_error, which belong to one
/// run?
bool is_of_step(Reduction reduction);

/// Such a number of the rows of one run that are selected, of which there is at least one. As stepinfo of
/// MATLAB has them, with the first of these rows as the initial value and the last one as the final value;
/// times count from the first one and are linear between rows. nan where the signal ends where it began, or a
/// value is nan.
double reduce_step(Reduction reduction, const Rows& rows);

}  // namespace stepwire::claim

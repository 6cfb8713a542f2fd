#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// Returns the workspace places of diagnostics that end a run: as a fault, or as `stop_when` does.
std::vector<std::size_t> places_of_ends(const Plan& plan, bool as_fault);

/// True if a run may end at an event between two ticks: by `stop_when`, or by the fault of a block.
bool may_end_between(const Plan& plan);

}  // namespace stepwire::plan

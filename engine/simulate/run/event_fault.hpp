#pragma once

#include <optional>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/run_fault.hpp"

namespace stepwire::run {

/// The fault of a run that the events of a step have ended, from the numbers of its workspace; empty for any
/// other. `tick_time`: of the tick behind the step [s].
std::optional<RunFault> fault_of_events(const plan::Plan& plan, const double* values, double tick_time);

}  // namespace stepwire::run

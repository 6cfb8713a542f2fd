#pragma once

#include <optional>
#include <string>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/run_fault.hpp"

namespace stepwire::run {

/// Of a block, or of its port where one is named, at a time [s].
RunFault fault_of(const plan::Plan& plan, std::size_t block, const std::string& port, double time,
                  const std::string& message);

// Faults from the numbers of a run's workspace; empty where there is none of the kind. `tick_time` is the
// time of the tick behind the last step [s].

/// Events of a step that are too many, or never settle.
std::optional<RunFault> fault_of_events(const plan::Plan& plan, const double* values, double tick_time);
/// The first algebraic loop that is not solved.
std::optional<RunFault> fault_of_loops(const plan::Plan& plan, const double* values);
/// True where numbers of this loop are no longer finite.
bool runs_away_in_loop(const plan::Plan& plan, const double* values);
/// A step that the solver finds wrong.
std::optional<RunFault> fault_of_step(const plan::Plan& plan, const double* values, double tick_time);

}  // namespace stepwire::run

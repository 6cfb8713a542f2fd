#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/run_fault.hpp"

namespace stepwire::run {

/// Returns a fault of a block, or of its port if one is named, at a time [s].
RunFault fault_of(const plan::Plan& plan, std::size_t block, const std::string& port, double time,
                  const std::string& message);

// Faults from the numbers of a run's workspace; std::nullopt without a fault of the kind. `tick_time` is the
// time of the tick after the last step [s].

/// Returns the fault of a step with too many events, or with an event that does not converge.
std::optional<RunFault> fault_of_events(const plan::Plan& plan, const double* values, double tick_time);
/// Returns the fault of the first algebraic loop that is not solved.
std::optional<RunFault> fault_of_loops(const plan::Plan& plan, const double* values);
/// True if numbers of this loop are not finite.
bool runs_away_in_loop(const plan::Plan& plan, const double* values);
/// Returns the fault of a step that the solver rejects.
std::optional<RunFault> fault_of_step(const plan::Plan& plan, const double* values, double tick_time);

/// Returns a note for each state of a run with error control that stays below a hundred times the absolute
/// tolerance, since this allows an error above 1 % of it. A state that is 0 throughout has none.
std::vector<RaisedDiagnostic> notes_on_small_states(const plan::Plan& plan, const double* values);

/// Returns a note for each block with continuous states whose reset follows from these states and is true at
/// both last ticks: the state has gone on beyond the condition. A run with located events has none.
std::vector<RaisedDiagnostic> notes_on_held_resets(const plan::Plan& plan, const double* values);

}  // namespace stepwire::run

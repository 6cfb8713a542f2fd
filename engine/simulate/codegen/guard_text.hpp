#pragma once

#include <string>

#include "engine/simulate/codegen/names.hpp"

namespace stepwire::codegen {

// The actions of run::Guards as C++.

/// Returns statements that copy numbers within the workspace.
std::string copy_text(std::size_t from, std::size_t to, std::size_t size);

/// Returns the ticks of a period as a condition, "tick % 4 == 1"; an empty text for every tick.
std::string due_text(const plan::Period& period);
/// Returns the number that enables a call, "w[at::pump_active]"; an empty text for a call that is always
/// active.
std::string active_text(const PlaceNames& names, std::ptrdiff_t active);
/// Returns the call of a guard and the actions of its change.
std::string guard_call(const PlaceNames& names, const plan::Plan& plan, std::size_t guard,
                       const std::string& call);
/// Returns the body of the function `off_N` of a guard, which is called when it switches off.
std::string off_text(const PlaceNames& names, const plan::Plan& plan, std::size_t guard);
/// Returns the first part of the function `reset_N`, which sets states to their initial values.
std::string reset_text(const plan::PlannedGuard& guard);
/// Returns statements that store, before the solver's step, the numbers that its stages overwrite.
std::string keep_text(const PlaceNames& names, const plan::Plan& plan);
/// Returns statements that set the derivatives to 0 that are only computed while a guard is active, if
/// derivatives have a place of their own.
std::string zero_slopes_text(const plan::Plan& plan);

}  // namespace stepwire::codegen

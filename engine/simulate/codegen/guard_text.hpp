#pragma once

#include <string>

#include "engine/simulate/codegen/names.hpp"

namespace stepwire::codegen {

// What run::Guards does, as C++.

/// Copies numbers from one place of the workspace to another.
std::string copy_text(std::size_t from, std::size_t to, std::size_t size);

/// The ticks of a period as a condition: "tick % 4 == 1". Empty for every tick.
std::string due_text(const plan::Period& period);
/// "w[at::pump_active]", the number by which a call is made; empty where it always is.
std::string active_text(const PlaceNames& names, std::ptrdiff_t active);
/// The call of a guard, with what follows from it.
std::string guard_call(const PlaceNames& names, const plan::Plan& plan, std::size_t guard,
                       const std::string& call);
/// The body of the function `off_N` of a guard, which is called as it goes off.
std::string off_text(const PlaceNames& names, const plan::Plan& plan, std::size_t guard);
/// The first part of the function `reset_N`: states take their initial values.
std::string reset_text(const plan::PlannedGuard& guard);
/// Before the solver's step: what its stages overwrite.
std::string keep_text(const PlaceNames& names, const plan::Plan& plan);
/// Slopes that are 0 unless derivatives are computed, where slopes have a place of their own.
std::string zero_slopes_text(const plan::Plan& plan);

}  // namespace stepwire::codegen

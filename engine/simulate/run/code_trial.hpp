#pragma once

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::run {

/// The longest trial of new code [ticks of all its runs]; one of slow ticks ends after some seconds.
inline constexpr std::int64_t trial_ticks = 1000;

/// Returns the trial that compares new code with the interpreter. Both step a run of their own from time 0
/// on, for at most `trial_ticks`. All signals, states and diagnostics are compared at each tick, bit by bit;
/// in lanes, states that differ between them begin with other values in each. A trial has a process of its
/// own, which code that crashes ends alone.
const plan::CodeTrial& code_trial();

}  // namespace stepwire::run

#pragma once

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::run {

/// Largest length of a trial of new code [ticks, all runs together]. A trial with slow ticks ends after some
/// seconds.
inline constexpr std::int64_t trial_ticks = 1000;

/// Returns the trial that compares new code with the interpreter.
///
/// Both step a run of their own from time 0, for at most `trial_ticks`. All signals, states and diagnostics
/// are compared bit by bit at each tick. In lanes, the states that may differ between runs have other initial
/// values in each lane. The trial is a separate process, so code that crashes does not end this one.
const plan::CodeTrial& code_trial();

}  // namespace stepwire::run

#pragma once

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::run {

/// The longest trial of new code [ticks of all its runs]; one of slow ticks ends after some seconds.
inline constexpr std::int64_t trial_ticks = 1000;

/// Compares new code with the interpreter. Both step a run of their own from time 0 on, for at most
/// `trial_ticks`. All signals, states and diagnostics are compared at each tick, bit by bit. A trial has a
/// process of its own, which code that crashes ends alone.
class CodeTrial : public plan::CodeTrial {
 public:
  std::string fault(const plan::Plan& plan, const plan::CompiledPlan& code) const override;
  /// States that the code has for each lane begin with other values in each.
  std::string fault(const plan::Plan& plan, const plan::CompiledLanes& code) const override;
};

/// Returns the only one; it has no state.
const CodeTrial& code_trial();

}  // namespace stepwire::run

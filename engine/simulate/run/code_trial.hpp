#pragma once

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::run {

/// The longest trial of new code [ticks of all its runs].
inline constexpr std::int64_t trial_ticks = 1000;

/// Compares new code with the interpreter: both step a run of their own from time 0 on, for at most
/// `trial_ticks`, and all signals, states and diagnostics are compared at each tick, bit by bit.
class CodeTrial : public plan::CodeTrial {
 public:
  std::string difference(const plan::Plan& plan, const plan::CompiledPlan& code) const override;
  /// The runs of the lanes begin with different states where the code has states of their own for them.
  std::string difference(const plan::Plan& plan, const plan::CompiledLanes& code) const override;
};

/// The one there is; it has no state.
const CodeTrial& code_trial();

}  // namespace stepwire::run

#pragma once

#include <atomic>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/run/background_compilation.hpp"
#include "engine/simulate/run/execution_mode.hpp"

namespace stepwire::run {

/// Compiles the plans of some runs, at once or in the background, and returns the code when it is ready.
class TieredExecution {
 public:
  /// `ticks` is the number of ticks of all runs together.
  TieredExecution(ExecutionMode engine, plan::CodeSource* source, std::vector<PlanOfRuns> plans,
                  double ticks);

  /// Returns the code of the plan with this index. Returns nullptr while it is not ready, and for a plan that
  /// was added later. Thread-safe.
  const plan::CompiledPlan* code(std::size_t plan) const;
  /// Adds `ticks` to the number of done ticks. Thread-safe.
  void done(std::int64_t ticks) { compilation_.done(ticks); }

 private:
  bool compile(const plan::CodeLimits& limits);

  plan::CodeSource* source_;
  std::vector<PlanOfRuns> plans_;
  std::atomic<bool> ready_ = false;
  std::vector<plan::CompiledPlan> code_;
  BackgroundCompilation compilation_;  ///< last member: its thread uses the others
};

}  // namespace stepwire::run

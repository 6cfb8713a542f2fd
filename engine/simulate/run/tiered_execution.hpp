#pragma once

#include <atomic>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/run/background_compilation.hpp"
#include "engine/simulate/run/execution_mode.hpp"

namespace stepwire::run {

/// Compiles the plans of some runs, at once or beside them, and hands out the code when it is there.
class TieredExecution {
 public:
  /// A plan of some runs.
  struct Member {
    const plan::Plan* plan;
    std::vector<plan::VariableBlock> variable;  ///< what differs between its runs
  };

  /// All runs together have `ticks` to go.
  TieredExecution(ExecutionMode engine, plan::CodeSource* source, std::vector<Member> plans, double ticks);

  /// The code of the i-th plan; null while there is none, and of a plan that has come later. From any thread.
  const plan::CompiledPlan* code(std::size_t plan) const;
  /// Notes that so many more ticks are done. From any thread.
  void done(std::int64_t ticks) { compilation_.done(ticks); }

 private:
  bool compile(const plan::CodeLimits& limits);

  plan::CodeSource* source_;
  std::vector<Member> plans_;
  std::atomic<bool> ready_ = false;
  std::vector<plan::CompiledPlan> code_;
  BackgroundCompilation compilation_;  ///< last: it uses the others
};

}  // namespace stepwire::run

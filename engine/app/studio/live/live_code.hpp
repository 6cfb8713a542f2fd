#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/tiered_execution.hpp"

namespace stepwire::live {

/// Compiles the plan of a run beside it, once that is worth it, so that the parameters of the file may be set
/// in compiled code; after another value has been set, the plan is compiled anew with that one.
class LiveCode {
 public:
  /// Plan and source must outlive it; without a source all is interpreted.
  LiveCode(const plan::Plan& plan, plan::CodeSource* source);

  /// Notes that ticks are done, and lets the run go on with the code where there is some.
  void look(run::Executor& run, std::int64_t ticks);
  /// A value of this name is set in the run, and may be again.
  void was_set(const std::string& name);

 private:
  void compile();

  const plan::Plan& plan_;
  plan::CodeSource* source_;
  std::set<std::string> names_;  ///< that may be set in compiled code
  std::vector<plan::VariableBlock> variable_;
  std::unique_ptr<run::TieredExecution> code_;
};

}  // namespace stepwire::live

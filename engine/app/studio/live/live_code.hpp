#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/tiered_execution.hpp"

namespace stepwire::live {

/// Compiler of the plan of a live run, in the background and only for runs that are long enough. Parameters
/// of the diagram can be set in the compiled code. Setting any other value triggers a new compilation with
/// that value as a variable.
class LiveCode {
 public:
  /// Plan and source must outlive it; without a source the run is interpreted.
  LiveCode(const plan::Plan& plan, plan::CodeSource* source);

  /// Counts computed ticks, and switches the run to compiled code once that is available.
  void look(run::Executor& run, std::int64_t ticks);
  /// Records that a value was set, so that the next compilation makes it a variable.
  void was_set(const std::string& name);

 private:
  void compile();

  const plan::Plan& plan_;
  plan::CodeSource* source_;
  std::set<std::string> names_;  ///< names that can be set in compiled code
  std::vector<plan::VariableBlock> variable_;
  std::unique_ptr<run::TieredExecution> code_;
};

}  // namespace stepwire::live

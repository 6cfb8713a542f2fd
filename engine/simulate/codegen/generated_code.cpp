#include "engine/simulate/codegen/generated_code.hpp"

#include "engine/base/subprocess/process.hpp"

namespace stepwire::codegen {

std::optional<plan::CompiledPlan> GeneratedCode::compile(const plan::Plan& plan,
                                                         const std::vector<plan::VariableBlock>& variable,
                                                         const std::stop_token& stop) {
  const std::lock_guard lock(mutex_);
  try {
    const plan::StepFunctions functions = functions_of(make_steps(plan, variable), stop);
    if (functions.evaluate && functions.advance) return plan::CompiledPlan{functions, variable};
  } catch (const std::exception& error) {  // no reason to end a run, which goes on without
    note(error.what());
  }
  return std::nullopt;
}

plan::StepFunctions GeneratedCode::functions_of(const GeneratedProgram& program,
                                                const std::stop_token& stop) {
  if (!compiler_) compiler_.emplace();
  if (!compiler_->found()) {
    note(compiler_->problem());
    return {};
  }
  if (const auto known = known_.find(program.text); known != known_.end()) return known->second;
  std::string problem;
  const plan::StepFunctions functions = cache_.load(program, *compiler_, stop, problem);
  if (!problem.empty() && !stop.stop_requested()) note(problem);
  if (functions.evaluate && functions.advance) known_.emplace(program.text, functions);
  return functions;
}

std::string GeneratedCode::take_problem() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problem_, "");
}

void GeneratedCode::note(const std::string& problem) {
  if (subprocess::processes_stop()) return;  // an interruption explains itself
  if (!std::exchange(noted_, true)) problem_ = problem;
}

}  // namespace stepwire::codegen

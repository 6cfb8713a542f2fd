#include "engine/simulate/codegen/generated_code.hpp"

#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/codegen/lane_places.hpp"

namespace stepwire::codegen {

namespace {

/// Returns the count of numbers in a vector register of this processor; 1 if lanes are no faster.
int lanes_of_processor() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) return 8;
  if (__builtin_cpu_supports("avx2")) return 4;
#endif
  return 1;
}

/// Returns the first error in the compiler's messages.
std::string first_error(const std::string& problem) {
  const std::size_t error = problem.find("error: ");
  return error == std::string::npos ? problem
                                    : "a block of it cannot be in lanes: " +
                                          problem.substr(error + 7, problem.find('\n', error) - error - 7);
}

}  // namespace

std::optional<plan::CompiledPlan> GeneratedCode::compile(const plan::Plan& plan,
                                                         const std::vector<plan::VariableBlock>& variable,
                                                         const plan::CodeLimits& limits) {
  const std::lock_guard lock(mutex_);
  try {
    std::string problem;
    const auto trial = [&](const ProgramFunctions& made) {
      return trial_.fault(plan, plan::CompiledPlan{made.steps, variable});
    };
    const ProgramFunctions functions = functions_of(make_steps(plan, variable), limits, trial, problem);
    if (functions) return plan::CompiledPlan{functions.steps, variable};
    if (!problem.empty() && !limits.only_kept) note(problem);  // a lookup in the cache may fail
  } catch (const std::exception& error) {                      // a run continues without code
    if (!limits.only_kept) note(error.what());
  }
  return std::nullopt;
}

std::optional<plan::CompiledLanes> GeneratedCode::compile_lanes(const plan::Plan& plan,
                                                                const plan::RunDifferences& differences,
                                                                const plan::CodeLimits& limits,
                                                                std::string& why) {
  const std::lock_guard lock(mutex_);
  const int lanes = lanes_of_processor();
  why = lanes == 1 ? "this processor has neither AVX2 nor AVX-512" : why_not_in_lanes(plan);
  if (!why.empty()) return std::nullopt;
  try {
    const GeneratedProgram program = make_lanes(plan, differences, lanes);
    plan::CompiledLanes code{nullptr, lanes, differences.variable,
                             lane_places(plan, differences, lanes).places};
    if (flags_for_this_machine(program.headers).empty())
      why = "blocks of it use other libraries";
    else if (load_lanes(plan, program, limits, code, why))
      return code;
  } catch (const std::exception& error) {
    why = error.what();
  }
  return std::nullopt;
}

bool GeneratedCode::load_lanes(const plan::Plan& plan, const GeneratedProgram& program,
                               const plan::CodeLimits& limits, plan::CompiledLanes& code, std::string& why) {
  std::string problem, fault;
  const auto trial = [&](const ProgramFunctions& made) {
    code.run = made.run;
    return fault = trial_.fault(plan, code);
  };
  code.run = functions_of(program, limits, trial, problem).run;
  if (!fault.empty()) note(fault);
  why = first_error(problem);
  return code.run != nullptr;
}

int GeneratedCode::lanes() {
  const std::lock_guard lock(mutex_);
  if (!compiler_) compiler_.emplace();
  return compiler_->found() && compiler_->is_gcc() ? lanes_of_processor() : 1;
}

ProgramFunctions GeneratedCode::functions_of(const GeneratedProgram& program, const plan::CodeLimits& limits,
                                             const CodeCache::Trial& trial, std::string& problem) {
  if (!compiler_) compiler_.emplace();
  if (!compiler_->found()) problem = compiler_->problem();
  if (program.lanes > 1 && compiler_->found() && !compiler_->is_gcc())
    problem = compiler_->version() + " does not put runs into lanes; g++ does";
  if (!problem.empty()) return {};
  const std::string source = library_source(program);
  if (const auto known = known_.find(source); known != known_.end()) return known->second;
  const ProgramFunctions functions = cache_.load(program, *compiler_, limits, trial, problem);
  if (limits.stop.stop_requested()) problem.clear();
  if (functions) known_.emplace(source, functions);
  return functions;
}

std::string GeneratedCode::take_problem() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problem_, "");
}

void GeneratedCode::note(const std::string& problem) {
  if (subprocess::processes_stop()) return;  // an interruption is no problem to report
  if (!std::exchange(noted_, true)) problem_ = problem;
}

}  // namespace stepwire::codegen

#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/plan/plan.hpp"

namespace stepwire {

/// What a plan is once it has been compiled: the same calls as the interpreter makes, on the same numbers.
/// `values` is the workspace of a run, `parameters` what differs between plans that share the code.
struct StepFunctions {
  void (*evaluate)(double* values, const double* parameters, std::int64_t tick) = nullptr;
  void (*advance)(double* values, const double* parameters, std::int64_t tick) = nullptr;
};

/// A plan's code with its own parameters.
struct CompiledPlan {
  StepFunctions functions;
  std::vector<double> parameters;
};

/// Where compiled code comes from.
class CodeSource {
 public:
  virtual ~CodeSource() = default;
  /// Compiles; gives for each of the plans its code, or nothing at all where that cannot be. A stop gives up.
  virtual std::vector<CompiledPlan> compile(const std::vector<const Plan*>& plans,
                                            const std::stop_token& stop) = 0;
  /// The numbers that code of this plan reads, in the order of `CompiledPlan::parameters`. Throws Error where
  /// the plan has no code.
  virtual std::vector<double> numbers(const Plan& plan) const = 0;
};

}  // namespace stepwire

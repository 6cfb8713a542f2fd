#pragma once

#include <cstdint>

namespace stepwire {

/// What a plan is once it has been compiled: the same calls as the interpreter makes, on the same numbers.
/// `values` is the workspace of a run, `parameters` what the program was made with that differs between the
/// plans that share it.
struct StepFunctions {
  void (*evaluate)(double* values, const double* parameters, std::int64_t tick) = nullptr;
  void (*advance)(double* values, const double* parameters, std::int64_t tick) = nullptr;
};

}  // namespace stepwire

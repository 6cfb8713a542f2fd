#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::device {

/// Text of a kernel, one run a thread, in C++. For a device it defines the kernel `stepwire_runs`, whose
/// argument is a Piece. For the processor it defines a function of this name with the same argument, which
/// steps one run after the other, by which tests compare it.
struct KernelText {
  std::string source;
  std::vector<std::string> headers;  ///< headers of stepwire that it includes
};

/// Name of the kernel.
inline constexpr const char* kernel_name = "stepwire_runs";

/// Returns the reason why the runs of a plan cannot go to a device, as a sentence; an empty text without
/// one. The compiler may refuse further plans. Throws EnvironmentError if headers are missing.
std::string why_not_on_device(const plan::Plan& plan);

/// Returns the kernel of a plan, which reads the `variable` members from a NumberTable. Throws Error for
/// blocks of which no code can be generated.
KernelText make_kernel(const plan::Plan& plan, const std::vector<plan::VariableBlock>& variable);

}  // namespace stepwire::device

#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

/// Returns the reason why a diagram has outputs and derivatives at ticks only, as a part of a sentence. The
/// text is empty if external solvers may evaluate it at any time.
std::string why_ticks_only(const plan::Plan& plan);

/// Returns the members of the struct for external solvers.
std::string between_ticks_members(const plan::Plan& plan);

/// Returns the statements of an evaluation after its outputs.
std::string slopes_of_evaluation(const plan::Plan& plan);

/// Returns the definitions of these members. `numbers` are those that blocks read; `before` and `after`
/// enclose every evaluation.
std::string between_ticks_definitions(const plan::Plan& plan, const std::string& numbers,
                                      const std::string& before, const std::string& after);

}  // namespace stepwire::codegen

#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire::codegen {

/// Why a diagram has outputs and slopes at ticks alone, as a part of a sentence; empty where solvers of
/// others may look at it at any time.
std::string why_ticks_only(const plan::Plan& plan);

/// Members of the struct for these solvers.
std::string between_ticks_members(const plan::Plan& plan);

/// What evaluate_here() does behind its outputs.
std::string evaluate_here_text(const plan::Plan& plan);

/// Their definitions: `numbers` are those that blocks read, `before` and `after` what stands around every
/// evaluation.
std::string between_ticks_definitions(const plan::Plan& plan, const std::string& numbers,
                                      const std::string& before, const std::string& after);

}  // namespace stepwire::codegen

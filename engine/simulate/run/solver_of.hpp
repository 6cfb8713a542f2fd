#pragma once

#include <memory>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

/// The solver that a plan names; null without continuous states. Throws Error for one that is not known, or
/// does not go with control of the error, or without.
std::unique_ptr<solve::Solver> solver_of(const plan::Plan& plan);

}  // namespace stepwire::run

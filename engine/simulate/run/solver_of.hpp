#pragma once

#include <memory>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

/// Returns the solver that a plan names; nullptr without continuous states. Throws Error for an unknown
/// solver, and for one that is used with error control but has none, or the other way round.
std::unique_ptr<solve::Solver> solver_of(const plan::Plan& plan);

}  // namespace stepwire::run

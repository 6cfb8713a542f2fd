#pragma once

#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// Refuse what would take memory that is not there, before it is taken: what a job records (all runs of a
/// sweep together), and the matrices of an implicit solver. Throw EnvironmentError that says how much it is
/// and how much is free.
void require_memory(const Job& job);
void require_solver_memory(const plan::Plan& plan);

}  // namespace stepwire::run

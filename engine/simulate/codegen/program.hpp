#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// Computations of a plan as C++ functions on the numbers of its workspace:
///
///     void evaluate(double* w, const double* numbers, std::int64_t tick)   outputs at a tick
///     void advance(double* w, const double* numbers, std::int64_t tick)    updates, then the solver
///     void reset(double* w, const double* numbers)                         everything at time 0
///
/// Their results have the same bits as those of Executor.
struct GeneratedProgram {
  std::string text;                  ///< names of places, tables and the functions, without a namespace
  std::vector<std::string> headers;  ///< needed headers, from the root of the sources
  int lanes = 1;                     ///< runs that it steps together
  bool uses_libm = false;            ///< as Diagram::uses_libm
};

/// Generates a standalone program with the plan's values. Throws Error for blocks that no program can have,
/// with their lines. Variable values are read from `numbers`, those of the tuning; then there is also
///
///     void follow_values(double* w, const double* numbers)   recomputes the numbers that depend on `numbers`
///
/// With `between_ticks`, which requires an empty why_ticks_only(), there is also
///
///     void evaluate_here(double* w, const double* numbers)   outputs and derivatives at the time and states
///     in w
///     void evaluate_between(double* w, const double* numbers)   the same with the branches of the last
///     evaluate_here(); it exists where branches are events
GeneratedProgram make_program(const plan::Plan& plan, const Tuning& tuning = {}, bool between_ticks = false);

/// Generates the steps only, for runs that begin in the interpreter: without reset(), and with the `variable`
/// members read from a NumberTable.
GeneratedProgram make_steps(const plan::Plan& plan, const std::vector<plan::VariableBlock>& variable);

/// Generates the steps of several runs in lanes, which have these differences; requires an empty
/// why_not_in_lanes():
///
///     void run(plan::LaneTask& task)
GeneratedProgram make_lanes(const plan::Plan& plan, const plan::RunDifferences& differences, int lanes);

}  // namespace stepwire::codegen

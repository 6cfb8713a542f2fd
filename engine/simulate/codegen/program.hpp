#pragma once

#include <string>
#include <vector>

#include "engine/simulate/codegen/tuning.hpp"

namespace stepwire::codegen {

/// What a plan computes, as functions of C++ on the numbers of its workspace:
///
///     void evaluate(double* w, const double* numbers, std::int64_t tick)   outputs at a tick
///     void advance(double* w, const double* numbers, std::int64_t tick)    updates, then the solver
///     void reset(double* w, const double* numbers)                         everything at time 0
///
/// They do bit by bit what Executor does.
struct GeneratedProgram {
  std::string text;                  ///< names of places, tables and the functions; inside of namespaces
  std::vector<std::string> headers;  ///< that it needs, from the root of the sources
  int lanes = 1;                     ///< runs that it steps together
};

/// A program that begins by itself, with the plan's values. Throws Error for blocks that no program can have,
/// with their lines. What may change is read from `numbers`, those of the tuning; then there is also
///
///     void follow_values(double* w, const double* numbers)   what follows from the numbers alone, once more
///
/// With `between_ticks`, for which why_ticks_only() has to be empty, also
///
///     void evaluate_here(double* w, const double* numbers)   outputs and slopes for the time and the states
///     in w
GeneratedProgram make_program(const plan::Plan& plan, const Tuning& tuning = {}, bool between_ticks = false);

/// The steps alone, for runs that begin in the interpreter: without reset(), and `variable` members read from
/// a NumberTable.
GeneratedProgram make_steps(const plan::Plan& plan, const std::vector<plan::VariableBlock>& variable);

/// The steps of several runs together, which differ in these; why_not_in_lanes() has to be empty:
///
///     void run(plan::LaneTask& task)
GeneratedProgram make_lanes(const plan::Plan& plan, const plan::RunDifferences& differences, int lanes);

}  // namespace stepwire::codegen

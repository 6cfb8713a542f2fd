#pragma once

#include <string>
#include <vector>

#include "engine/generate/literals.hpp"
#include "engine/plan/plan.hpp"

namespace stepwire {

/// What a plan computes, as functions of C++ on the numbers of its workspace:
///
///     void evaluate(double* w, const double* parameters, std::int64_t tick)   outputs at a tick
///     void advance(double* w, const double* parameters, std::int64_t tick)    updates, then the solver
///     void reset(double* w, const double* parameters)                         everything at time 0
///
/// They do bit by bit what Simulation does.
struct GeneratedProgram {
  std::string text;                  ///< names of places, tables and the functions; inside of namespaces
  std::vector<std::string> headers;  ///< that it needs, from the root of the sources
  ProgramNumbers parameters;
};

/// The numbers of a plan's program, without its text, which takes the longest where a plan has records.
/// Throws as make_program does.
ProgramNumbers numbers_of(const Plan& plan);

/// The program with every number as a parameter: plans for which its text is the same differ in numbers
/// alone.
GeneratedProgram outline_of(const Plan& plan);

/// Throws Error for blocks that no program can have, with their lines. `varying` says which numbers are
/// parameters; without it none is.
GeneratedProgram make_program(const Plan& plan, const Varying* varying = nullptr);

}  // namespace stepwire

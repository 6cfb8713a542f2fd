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
  std::vector<double> parameters;    ///< every number of the blocks, in order; then lists that stand apart
  std::size_t before_lists = 0;      ///< how many numbers stand in front of these lists
};

/// Throws Error for blocks that no program can have, with their lines. `varying` says which numbers are
/// parameters; without it none is. It has an entry for each number, those of lists that stand apart aside:
/// they always are parameters.
GeneratedProgram make_program(const Plan& plan, const Varying* varying = nullptr,
                              Lists lists = Lists::in_place);

}  // namespace stepwire

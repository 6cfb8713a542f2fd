#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// What an algebraic loop has cost in a run.
struct LoopCost {
  std::string path;                       ///< "error -> half -> error"
  std::int64_t unknowns = 0;              ///< numbers at which it is torn
  std::int64_t instants = 0;              ///< at which it was solved: ticks and stages of the solver
  std::int64_t iterations = 0, most = 0;  ///< passes through its blocks: all together, and at one instant
  std::int64_t unsolved = 0;              ///< instants at which no solution was found
  double first_unsolved = 0.0;            ///< [s]

  /// Adds what another run of the same loop has cost.
  LoopCost& operator+=(const LoopCost& other);
};

/// Adds the loops of a run to those of others; loops of one path are one.
void add_loops(std::vector<LoopCost>& all, const std::vector<LoopCost>& more);

/// The cost of each loop of a plan up to now, from the numbers of a run's workspace.
std::vector<LoopCost> loop_costs(const plan::Plan& plan, const double* values);

}  // namespace stepwire::run

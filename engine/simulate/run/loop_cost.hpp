#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::run {

/// Cost of an algebraic loop in a run.
struct LoopCost {
  std::string path;                       ///< Text "error -> half -> error".
  std::int64_t unknowns = 0;              ///< Numbers at which the loop is torn.
  std::int64_t instants = 0;              ///< Ticks and solver stages at which it was solved.
  std::int64_t iterations = 0, most = 0;  ///< Passes through its blocks, total and maximum.
  std::int64_t unsolved = 0;              ///< Instants without a solution.
  double first_unsolved = 0.0;            ///< Time of the first of them [s].

  /// Adds the cost of the same loop in another run.
  LoopCost& operator+=(const LoopCost& other);
};

/// Adds the loop costs of one run to those of others; loops of the same path are merged.
void add_loops(std::vector<LoopCost>& all, const std::vector<LoopCost>& more);

/// Returns the cost of each loop of a plan up to now, from the numbers of a run's workspace.
std::vector<LoopCost> loop_costs(const plan::Plan& plan, const double* values);

}  // namespace stepwire::run

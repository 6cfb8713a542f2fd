#pragma once

#include <vector>

#include "engine/simulate/solve/tableau.hpp"

namespace stepwire::solve {

/// What an explicit method does with a slope as soon as it is known: to = from + step weight slope.
struct Addition {
  static constexpr int states = -1;  ///< the states at which the next slope is wanted, or the result
  static constexpr int start = 0;  ///< the states at the start of the step; above are sums that wait for more
  int from, to;
  double weight;
};

/// One stage of an explicit method.
struct SolverStage {
  std::vector<Addition> additions;
  double next = 1.0;  ///< time of the next stage, in steps
};

/// A Runge-Kutta method as a list of stages. No slope has to be kept.
std::vector<SolverStage> stages_of(const Tableau& tableau);

/// How many places the additions name, the start among them.
int places_of(const std::vector<SolverStage>& stages);

}  // namespace stepwire::solve

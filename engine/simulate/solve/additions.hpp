#pragma once

#include <vector>

#include "engine/simulate/solve/tableau.hpp"

namespace stepwire::solve {

/// Update of an explicit method with a new derivative: to = from + step weight derivative.
struct Addition {
  static constexpr int states = -1;  ///< Place of the states of the next stage, or of the result.
  static constexpr int start = 0;    ///< States at the start of the step. Larger places are partial sums.
  int from, to;
  double weight;
};

/// Stage of an explicit method.
struct SolverStage {
  std::vector<Addition> additions;
  double next = 1.0;  ///< time of the next stage, as a fraction of the step
};

/// Converts a Runge-Kutta method into a list of stages whose derivatives need not be stored: each derivative
/// is added to all partial sums at once.
std::vector<SolverStage> stages_of(const Tableau& tableau);

/// Returns the number of places in the additions, including the start.
int places_of(const std::vector<SolverStage>& stages);

}  // namespace stepwire::solve

#pragma once

#include <vector>

#include "engine/solve/solver.hpp"
#include "engine/solve/tableau.hpp"

namespace stepwire {

/// An explicit Runge-Kutta method in which every stage uses the slope before it. Each slope is added, as soon
/// as it is known, to every later stage that needs it, so that none has to be kept.
class ExplicitSolver : public Solver {
 public:
  ExplicitSolver(const Tableau& tableau, std::size_t states);
  void advance(System& system, double time, double step) override;

 private:
  /// What is done with a slope: to = from + step weight slope.
  struct Addition {
    int from, to;  ///< numbers of places
    double weight;
  };
  /// What to do with the slope at one stage, and when the next one is.
  struct Stage {
    std::vector<Addition> additions;
    double next = 1.0;  ///< time of the next stage, in steps
  };

  /// The place of a sum: the states themselves, those at the start of the step, or a row of `sums_`.
  double* place(int number, System& system);
  void use_slope(const Stage& stage, System& system, double step);

  std::vector<Stage> stages_;
  std::vector<double> sums_;  ///< states at the start, then one row for each sum that waits for more slopes
};

}  // namespace stepwire

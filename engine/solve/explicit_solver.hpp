#pragma once

#include <vector>

#include "engine/solve/additions.hpp"
#include "engine/solve/solver.hpp"

namespace stepwire {

/// An explicit Runge-Kutta method.
class ExplicitSolver : public Solver {
 public:
  ExplicitSolver(const Tableau& tableau, std::size_t states);
  void advance(System& system, double time, double step) override;

 private:
  /// The place of a sum: the states themselves, or a row of `sums_`.
  double* place(int number, System& system);
  void use_slope(const SolverStage& stage, System& system, double step);

  std::vector<SolverStage> stages_;
  std::vector<double> sums_;  ///< states at the start, then one row for each sum that waits for more slopes
};

}  // namespace stepwire

#pragma once

#include <span>
#include <vector>

#include "engine/simulate/solve/additions.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::solve {

/// Solver with an explicit Runge-Kutta method.
class ExplicitSolver : public Solver {
 public:
  ExplicitSolver(const Tableau& tableau, std::size_t states);
  void advance(System& system, const TimeStep& step) override;
  const double* start() const override { return sums_.data(); }

 private:
  /// Sum to = from + weight derivative.
  struct Sum {
    double* to;
    const double* from;
    double weight;
  };
  /// One or two sums that are computed in one pass through memory.
  struct Pass {
    Sum sums[2];
    bool two;
  };
  /// Additions with the derivative of a stage.
  struct Stage {
    std::vector<Pass> passes;
    double next;  ///< time of the next stage, as a fraction of the step
  };

  void prepare(const System& system, double length);
  Pass pass_of(const Addition* additions, bool two, const System& system, double length);
  void use_slope(const Stage& stage, const System& system) const;
  template <int count>
  void add(const Sum (&sums)[2], const System& system) const;

  std::vector<SolverStage> method_;
  std::vector<double> sums_;   ///< states at the start, then one row for each partial sum
  std::vector<Stage> stages_;  ///< stages for the states and the step of the last call
  const double* states_ = nullptr;
  double length_ = 0.0;
  StatePiece all_{};
  std::span<const StatePiece> pieces_;  ///< pieces of this step
};

}  // namespace stepwire::solve

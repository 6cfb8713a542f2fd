#pragma once

#include <span>
#include <vector>

#include "engine/simulate/solve/additions.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::solve {

/// An explicit Runge-Kutta method.
class ExplicitSolver : public Solver {
 public:
  ExplicitSolver(const Tableau& tableau, std::size_t states);
  void advance(System& system, const TimeStep& step) override;
  const double* start() const override { return sums_.data(); }

 private:
  /// to = from + weight slope
  struct Sum {
    double* to;
    const double* from;
    double weight;
  };
  /// One or two sums, on one way through memory.
  struct Pass {
    Sum sums[2];
    bool two;
  };
  /// What is to be done with the slope of a stage.
  struct Stage {
    std::vector<Pass> passes;
    double next;  ///< time of the next stage, in steps
  };

  void prepare(const System& system, double length);
  Pass pass_of(const Addition* additions, bool two, const System& system, double length);
  void use_slope(const Stage& stage, const System& system) const;
  template <int count>
  void add(const Sum (&sums)[2], const System& system) const;

  std::vector<SolverStage> method_;
  std::vector<double> sums_;   ///< states at the start, then one row for each sum that waits for more slopes
  std::vector<Stage> stages_;  ///< for the states and the step of the last call
  const double* states_ = nullptr;
  double length_ = 0.0;
  StatePiece all_{};
  std::span<const StatePiece> pieces_;  ///< of this step
};

}  // namespace stepwire::solve

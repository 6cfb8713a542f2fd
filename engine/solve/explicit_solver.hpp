#pragma once

#include <vector>

#include "engine/solve/solver.hpp"
#include "engine/solve/tableau.hpp"

namespace stepwire {

/// Any explicit Runge-Kutta method.
class ExplicitSolver : public Solver {
 public:
  ExplicitSolver(const Tableau& tableau, std::size_t states);
  void advance(System& system, double time, double step) override;

 private:
  /// One weight that is not 0: most of a tableau is.
  struct Term {
    std::size_t stage;
    double weight;
  };
  void combine(double* x, const std::vector<Term>& terms, double step) const;
  double* slope(std::size_t stage) { return slopes_.data() + stage * start_.size(); }

  std::vector<double> c_;
  std::vector<std::vector<Term>> rows_;
  std::vector<Term> b_;
  std::vector<double> start_;
  std::vector<double> slopes_;  ///< of all stages, one behind the other
};

}  // namespace stepwire

#pragma once

#include <Eigen/Core>

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
    Eigen::Index stage;
    double weight;
  };
  void combine(Eigen::Map<Eigen::VectorXd>& x, const std::vector<Term>& terms, double step) const;

  std::vector<double> c_;
  std::vector<std::vector<Term>> rows_;
  std::vector<Term> b_;
  Eigen::VectorXd start_;
  Eigen::MatrixXd slopes_;  ///< a column for each stage
};

}  // namespace stepwire

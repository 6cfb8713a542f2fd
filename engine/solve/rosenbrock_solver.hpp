#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "engine/solve/solver.hpp"

namespace stepwire {

/// The linearly implicit method behind MATLAB's ode23s (Shampine and Reichelt 1997, SIAM J. Sci. Comput.
/// 18(1)): order 2, L-stable, for stiff plants. The Jacobian is by forward differences: one evaluation for
/// each state and step.
class RosenbrockSolver : public Solver {
 public:
  explicit RosenbrockSolver(std::size_t states);
  void advance(System& system, double time, double step) override;

 private:
  void differentiate(System& system, double time, double step);

  Eigen::VectorXd start_, slope0_, slope1_, slope_time_, k1_, k2_, right_;
  Eigen::MatrixXd jacobian_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace stepwire

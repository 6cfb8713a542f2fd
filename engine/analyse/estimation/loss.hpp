#pragma once

#include <Eigen/Core>

#include "engine/analyse/estimation/residuals.hpp"

namespace stepwire::estimation {

/// A number whose square is what a residual r counts, and its derivative after r: r itself without a loss,
/// else 2 rho(r)'s root, with rho of Huber or Cauchy.
struct Counted {
  double value, slope;
};
Counted counted(double r, const FitRequest& request);

/// Puts what they count in the place of the residuals, and its derivatives in that of theirs.
void count(const FitRequest& request, Eigen::VectorXd& residuals, Jacobian& jacobian);

/// Half of the sum of what the residuals count.
double cost_of(const Eigen::VectorXd& residuals, const FitRequest& request);

}  // namespace stepwire::estimation

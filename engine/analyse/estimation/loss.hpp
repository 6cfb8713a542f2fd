#pragma once

#include <Eigen/Core>

#include "engine/analyse/estimation/residuals.hpp"

namespace stepwire::estimation {

/// A residual r after the loss: the signed root of 2 rho(r), with rho of Huber or Cauchy, and its derivative
/// by r. Without a loss it is r itself.
struct Counted {
  double value, slope;
};
Counted counted(double r, const FitRequest& request);

/// Replaces the residuals and their derivatives by those after the loss.
void count(const FitRequest& request, Eigen::VectorXd& residuals, Jacobian& jacobian);

/// Returns half of the sum of squares of the residuals after the loss.
double cost_of(const Eigen::VectorXd& residuals, const FitRequest& request);

}  // namespace stepwire::estimation

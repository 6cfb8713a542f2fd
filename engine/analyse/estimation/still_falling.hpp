#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/analyse/estimation/residuals.hpp"

namespace stepwire::estimation {

/// An unknown along which the cost still falls.
struct FallingUnknown {
  Eigen::Index unknown = 0;
  double cosine = 0.0;  ///< Absolute cosine between the residuals and the derivatives by the unknown.
};

/// Returns the unknowns along which the cost at x falls by more than a minimum allows. The arguments are the
/// residuals after the loss and their derivatives. The cosine between the residuals and each column of the
/// derivatives is 0 at a minimum, in any unit. It may be 1e-3 here. It also may have the value at which the
/// step that makes it 0 is within the tolerance of the request, relative to the unknown or to its standard
/// error. Unknowns at a bound towards which the cost falls do not count.
std::vector<FallingUnknown> still_falling(const Residuals& residuals, const FitRequest& request,
                                          const Eigen::VectorXd& x, const Eigen::VectorXd& r,
                                          const Jacobian& slopes);

/// Returns the note on a search that has ended where the cost still falls. The names are those of all
/// unknowns.
std::string falling_text(const std::vector<FallingUnknown>& falling, const std::vector<std::string>& names);

}  // namespace stepwire::estimation

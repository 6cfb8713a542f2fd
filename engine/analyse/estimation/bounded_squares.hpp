#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace stepwire::estimation {

/// Residuals of shares, numbers from 0 to 1 each.
struct BoundedSquares {
  /// Writes the residuals at a point and, unless null, their derivatives, one row for each residual; false: the
  /// point gives none. An exception ends the search, and is thrown again.
  std::function<bool(const std::vector<double>& at, double* residuals, double* jacobian)> evaluate;
  std::size_t residuals = 0;
  std::size_t iterations = 100;
  double tolerance = 1e-4;  ///< relative, of the point and of the sum of squares
};

/// Makes the sum of squares small by the Levenberg-Marquardt method of Ceres, from a point on. Gives whether it
/// converged; the best point is among those that were evaluated.
bool minimise_squares(const BoundedSquares& problem, const std::vector<double>& from);

}  // namespace stepwire::estimation

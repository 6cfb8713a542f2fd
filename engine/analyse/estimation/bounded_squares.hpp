#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace stepwire::estimation {

/// Least-squares problem over shares, numbers from 0 to 1 each.
struct BoundedSquares {
  /// Writes the residuals at a point and, unless nullptr, their derivatives, one row per residual. Returns
  /// false if the point has none. An exception ends the search and is rethrown.
  std::function<bool(const std::vector<double>& at, double* residuals, double* jacobian)> evaluate{};
  std::size_t residuals = 0;
  std::size_t iterations = 100;
  double tolerance = 1e-4;  ///< relative, of the point and of the sum of squares
};

/// Minimises the sum of squares from a point by the Levenberg-Marquardt method of Ceres. Returns true if
/// converged. The best point is among the evaluated ones.
bool minimise_squares(const BoundedSquares& problem, const std::vector<double>& from);

}  // namespace stepwire::estimation

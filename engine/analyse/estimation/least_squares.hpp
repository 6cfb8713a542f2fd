#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <limits>
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

/// Callback after each step, with its number and the cost so far.
using StepWatcher = std::function<void(std::size_t step, double cost)>;

/// Residuals at a point, and their derivatives by forward differences of runs.
struct KnownPoint {
  Eigen::VectorXd x, residuals;
  Jacobian slopes;  ///< Derivatives; empty if not computed.
};

struct LeastSquaresOptions {
  std::size_t iterations = 100;
  const std::atomic<bool>* interrupt = nullptr;  ///< Once true, the search ends with its best point.
  StepWatcher watch{};
  KnownPoint known{};  ///< Evaluated point; a search that begins there needs no run for it.
};

/// End of a search.
struct Minimum {
  Eigen::VectorXd x;
  double cost = std::numeric_limits<double>::infinity();  ///< Half of the sum of squares of the residuals
                                                          ///< after the loss.
  bool converged = false;
  bool stalled = false;  ///< True: no step lowers the cost any more, but it still falls along an unknown.
  std::size_t iterations = 0;
  std::string
      refusal{};  ///< Reason why the diagram refused a point, the first one refused; empty if none was.
};

/// Minimises the cost from a start by the Levenberg-Marquardt method, within the bounds and the values that
/// the diagram accepts. The cost is infinite if the start cannot be evaluated. See least_squares.cpp.
Minimum minimise(const Residuals& residuals, const FitRequest& request, const Eigen::VectorXd& start,
                 const LeastSquaresOptions& options);

}  // namespace stepwire::estimation

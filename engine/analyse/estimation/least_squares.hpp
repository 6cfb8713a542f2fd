#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <limits>
#include <string>

#include "engine/analyse/estimation/residuals.hpp"

namespace stepwire::estimation {

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

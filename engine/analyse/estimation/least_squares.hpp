#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <limits>
#include <string>

#include "engine/analyse/estimation/residuals.hpp"

namespace stepwire::estimation {

/// Told after each step: its number and the cost so far.
using StepWatcher = std::function<void(std::size_t step, double cost)>;

/// What the residuals are at a point, by runs with forward differences.
struct KnownPoint {
  Eigen::VectorXd x, residuals;
  Jacobian slopes;  ///< empty: not asked for
};

struct LeastSquaresOptions {
  std::size_t iterations = 100;
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, it ends with the best so far
  StepWatcher watch{};
  KnownPoint known{};  ///< needs no runs where the search begins there
};

/// Where a search came to.
struct Minimum {
  Eigen::VectorXd x;
  double cost = std::numeric_limits<double>::infinity();  ///< half of the sum of what the residuals count
  bool converged = false;
  std::size_t iterations = 0;
  std::string
      refusal{};  ///< why the diagram refused the first point that it refused; empty where it took all
};

/// Minimises the cost within the bounds, and within what the diagram takes, by Levenberg-Marquardt from a
/// start; the cost stays infinite where nothing could be evaluated at the start. See least_squares.cpp.
Minimum minimise(const Residuals& residuals, const FitRequest& request, const Eigen::VectorXd& start,
                 const LeastSquaresOptions& options);

}  // namespace stepwire::estimation

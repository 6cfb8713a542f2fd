#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::solve {

/// Computes the Jacobian of `dot` with respect to x at `start`, where the derivative is `slope`, with one
/// evaluation for each state. `x` is restored. The caller sets the time of the evaluations.
template <class Matrix, class X, class Dot, class Vector, class Evaluate>
void forward_differences(Matrix& jacobian, X& x, const Dot& dot, const Vector& start, const Vector& slope,
                         double step, const Evaluate& evaluate) {
  constexpr double smallest_scale = 1e-9;  // of a state that is 0, in its SI unit
  static const double root_epsilon = std::sqrt(std::numeric_limits<double>::epsilon());
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    // The scale of the derivative keeps the difference above rounding where the state passes through 0.
    const double scale = std::max({std::abs(start[j]), std::abs(step * slope[j]), smallest_scale});
    const double moved = start[j] + root_epsilon * scale;
    x[j] = moved;
    evaluate();
    jacobian.col(j) = (dot - slope) / (moved - start[j]);
    x[j] = start[j];
  }
}

}  // namespace stepwire::solve

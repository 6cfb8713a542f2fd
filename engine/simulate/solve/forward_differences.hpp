#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire::solve {

/// Computes the Jacobian of `dot` with respect to x at `start`, where the derivative is `slope`, with one
/// evaluation for each state. `x` is restored. The caller sets the time of the evaluations.
///
/// With `sided`, a difference across a jump of the derivative is replaced by the one to the other side. A
/// jump divided by the tiny distance would be a damping or growth that the equations do not have. Half of the
/// distance changes a smooth derivative by half, and one that jumps by all or nothing. Only a difference that
/// is large against the step is examined, with one evaluation or two.
template <class Matrix, class X, class Dot, class Vector, class Evaluate>
class ForwardDifferences {
 public:
  ForwardDifferences(Matrix& jacobian, X& x, const Dot& dot, const Vector& start, const Vector& slope,
                     double step, const Evaluate& evaluate)
      : jacobian_(jacobian),
        x_(x),
        dot_(dot),
        start_(start),
        slope_(slope),
        step_(step),
        evaluate_(evaluate) {}

  void run(bool sided) {
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
      const double moved = start_[j] + root_epsilon() * scale(j);
      move(j, moved);
      jacobian_.col(j) = (dot_ - slope_) / (moved - start_[j]);
      if (sided) avoid_jump(j, moved - start_[j]);
      x_[j] = start_[j];
    }
  }

 private:
  static double root_epsilon() { return std::sqrt(std::numeric_limits<double>::epsilon()); }
  /// Returns the scale of a state. That of its derivative keeps the difference above rounding where the state
  /// passes through 0.
  double scale(Eigen::Index i) const {
    constexpr double smallest_scale = 1e-9;  // of a state that is 0, in its SI unit
    return std::max({std::abs(start_[i]), std::abs(step_ * slope_[i]), smallest_scale});
  }
  void move(Eigen::Index j, double to) {
    x_[j] = to;
    evaluate_();
  }

  void avoid_jump(Eigen::Index j, double distance) {
    const Eigen::Index i = largest(distance);
    if (i < 0) return;
    const double change = dot_[i] - slope_[i];
    move(j, start_[j] + 0.5 * distance);
    if (std::abs(dot_[i] - slope_[i] - 0.5 * change) <= 0.3 * std::abs(change)) return;
    move(j, start_[j] - distance);
    if (std::abs(slope_[i] - dot_[i]) >= 0.1 * std::abs(change)) return;  // a jump on both sides
    jacobian_.col(j) = (slope_ - dot_) / distance;
  }

  /// Returns the derivative with the largest change against its step; -1 if the step resolves all of them.
  Eigen::Index largest(double distance) const {
    constexpr double resolved = 4.0;
    Eigen::Index found = -1;
    double most = resolved * root_epsilon();
    for (Eigen::Index i = 0; distance > 0.0 && i < x_.size(); ++i) {
      const double part = std::abs(step_ * (dot_[i] - slope_[i])) / scale(i);
      if (!(part > most)) continue;
      most = part;
      found = i;
    }
    return found;
  }

  Matrix& jacobian_;
  X& x_;
  const Dot& dot_;
  const Vector &start_, &slope_;
  const double step_;
  const Evaluate& evaluate_;
};

/// Computes the Jacobian as ForwardDifferences does.
template <class Matrix, class X, class Dot, class Vector, class Evaluate>
void forward_differences(Matrix& jacobian, X& x, const Dot& dot, const Vector& start, const Vector& slope,
                         double step, const Evaluate& evaluate, bool sided = false) {
  ForwardDifferences(jacobian, x, dot, start, slope, step, evaluate).run(sided);
}

}  // namespace stepwire::solve

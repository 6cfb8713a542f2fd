#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire {

/// The linearly implicit method behind MATLAB's ode23s (Shampine and Reichelt 1997, SIAM J. Sci. Comput.
/// 18(1)): order 2, L-stable, for stiff plants. The Jacobian is by forward differences: one evaluation for
/// each state and step. With `most_states` nothing is ever allocated; the results are the same to the last
/// bit.
template <int most_states = Eigen::Dynamic>
class Rosenbrock {
 public:
  explicit Rosenbrock(Eigen::Index states) : factors_(states) {
    for (Vector* vector : {&start_, &slope0_, &slope_time_, &k1_, &k2_, &right_}) vector->setZero(states);
    jacobian_.setZero(states, states);
  }

  /// Advances `x` by a step. On entry `dot` is evaluated at (time, x); evaluate() does that again for
  /// whatever stands in `x` and `*now`.
  template <class Evaluate>
  void advance(double* x_place, double* dot_place, double* now, double time, double step,
               const Evaluate& evaluate) {
    Eigen::Map<Vector> x(x_place, start_.size());
    const Eigen::Map<const Vector> dot(dot_place, start_.size());
    start_ = x;
    slope0_ = dot;
    differentiate(x, dot, now, time, step, evaluate);
    jacobian_ *= -step * d;
    jacobian_.diagonal().array() += 1.0;
    factors_.compute(jacobian_);
    right_ = slope0_ + (step * d) * slope_time_;
    k1_ = factors_.solve(right_);
    x = start_ + (0.5 * step) * k1_;
    *now = time + 0.5 * step;
    evaluate();
    right_ = dot - k1_;
    k2_ = factors_.solve(right_);
    x = start_ + step * (k2_ + k1_);
  }

 private:
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_states, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_states, most_states>;

  static constexpr double smallest_scale = 1e-9;  // of a state at rest at 0, in its own SI unit
  static inline const double root_epsilon = std::sqrt(std::numeric_limits<double>::epsilon());
  static inline const double d = 1.0 / (2.0 + std::sqrt(2.0));

  template <class X, class Dot, class Evaluate>
  void differentiate(X& x, const Dot& dot, double* now, double time, double step, const Evaluate& evaluate) {
    *now = time;
    for (Eigen::Index j = 0; j < x.size(); ++j) {
      // The slope's own scale keeps the difference above rounding where the state passes through 0.
      const double scale = std::max({std::abs(start_[j]), std::abs(step * slope0_[j]), smallest_scale});
      const double moved = start_[j] + root_epsilon * scale;
      x[j] = moved;
      evaluate();
      jacobian_.col(j) = (dot - slope0_) / (moved - start_[j]);
      x[j] = start_[j];
    }
    // Far from time 0 a tiny fraction of a step is lost in rounding; a tenth of the step is not, and its
    // error is of the method's own order.
    const double ahead = time + 0.1 * step;
    *now = ahead;
    evaluate();
    slope_time_ = (dot - slope0_) / (ahead - time);
  }

  Vector start_, slope0_, slope_time_, k1_, k2_, right_;
  Matrix jacobian_;
  Eigen::PartialPivLU<Matrix> factors_;
};

}  // namespace stepwire

#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/simulate/solve/forward_differences.hpp"
#include "engine/simulate/solve/step_check.hpp"
#include "engine/simulate/solve/step_report.hpp"

namespace stepwire::solve {

/// Method of MATLAB's ode23s for stiff plants (Shampine and Reichelt 1997, SIAM J. Sci. Comput. 18(1)):
/// linearly implicit, order 2, L-stable. The Jacobian by forward differences costs one evaluation for each
/// state and step. With `max_states` no memory is allocated, and the results are the same to the last bit.
template <int max_states = Eigen::Dynamic>
class Rosenbrock {
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_states, 1>;

 public:
  explicit Rosenbrock(Eigen::Index states) : factors_(states), check_(states) {
    for (Vector* vector : {&start_, &slope0_, &slope_time_, &k1_, &k2_, &right_, &half_, &next_, &error_})
      vector->setZero(states);
    jacobian_.setZero(states, states);
  }

  /// Integrates `x` over one step, from `time` to `end`. On entry `dot` must be the derivative at (time, x).
  /// evaluate() recomputes it for the present `x` and `*now`. A step whose error is beyond the tolerance is
  /// written to `report`.
  template <class Evaluate>
  void advance(double* x_place, double* dot_place, double* now, double time, double end, double step,
               const StepReport& report, const Evaluate& evaluate) {
    Eigen::Map<Vector> x(x_place, start_.size());
    const Eigen::Map<const Vector> dot(dot_place, start_.size());
    start_ = x;
    slope0_ = dot;
    differentiate(x, dot, now, time, step, bool(report), evaluate);
    jacobian_ *= -step * d;
    jacobian_.diagonal().array() += 1.0;
    factors_.compute(jacobian_);
    right_ = slope0_ + (step * d) * slope_time_;
    k1_ = factors_.solve(right_);
    x = start_ + (0.5 * step) * k1_;
    *now = time + 0.5 * step;
    evaluate();
    half_ = dot - k1_;
    k2_ = factors_.solve(half_);
    x = start_ + step * (k2_ + k1_);
    if (report) check(x, dot, now, time, end, step, report, evaluate);
  }
  /// Attempts a step and estimates its error, for a step size controller.
  template <class X, class Dot, class Evaluate>
  bool attempt(X& x, Dot& dot, double* now, double time, double end, double step, double*,
               const Evaluate& evaluate) {
    advance(x.data(), dot.data(), now, time, end, step, {}, evaluate);
    estimate(x, dot, now, end, step, evaluate);
    return error_.allFinite();
  }
  const Vector& error() const { return error_; }
  bool ends_with_slope() const { return true; }
  static constexpr double first_order = 3.0;
  /// Returns the order of the last attempt, for the choice of the next step size.
  double order() const { return 3.0; }

  /// Returns the states at the start of the last step.
  const double* start() const { return start_.data(); }

 private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_states, max_states>;

  static inline const double d = 1.0 / (2.0 + std::sqrt(2.0));
  static inline const double e32 = 6.0 + std::sqrt(2.0);

  template <class X, class Dot, class Evaluate>
  void differentiate(X& x, const Dot& dot, double* now, double time, double step, bool sided,
                     const Evaluate& evaluate) {
    *now = time;
    forward_differences(jacobian_, x, dot, start_, slope0_, step, evaluate, sided);
    // Far from time 0 a tiny fraction of a step would be lost in rounding. A tenth of the step is not, and
    // its error is of the method's own order.
    const double ahead = time + 0.1 * step;
    *now = ahead;
    evaluate();
    if (ahead > time)
      slope_time_ = (dot - slope0_) / (ahead - time);
    else  // the step is too short for a difference in time
      slope_time_.setZero();
  }

  /// Estimates the error as in the paper, from the derivative at the end.
  template <class X, class Dot, class Evaluate>
  void estimate(X& x, const Dot& dot, double* now, double end, double step, const Evaluate& evaluate) {
    next_ = x;
    *now = end;
    evaluate();
    // half_ is the derivative at the middle minus k1_; the second slope of the paper is k2_ + k1_.
    right_ = dot - e32 * (k2_ - half_) - 2.0 * (k1_ - slope0_) + (step * d) * slope_time_;
    error_ = factors_.solve(right_);
    error_ = (step / 6.0) * (error_ - k1_ - 2.0 * k2_);
  }

  template <class X, class Dot, class Evaluate>
  void check(X& x, const Dot& dot, double* now, double time, double end, double step,
             const StepReport& report, const Evaluate& evaluate) {
    estimate(x, dot, now, end, step, evaluate);
    WorstError own;
    for (Eigen::Index i = 0; i < start_.size(); ++i)
      own.add(error_[i], std::max(std::abs(start_[i]), std::abs(next_[i])), i);
    if (!(own.size > report.tolerance)) return;
    const WorstError found =
        check_.error(x, const_cast<double*>(dot.data()), start_, now, time, end, step, evaluate);
    if (found.size > report.tolerance) report.write(StepReport::inaccurate, found.size, found.state);
  }

  Vector start_, slope0_, slope_time_, k1_, k2_, right_, half_, next_, error_;
  Matrix jacobian_;
  Eigen::PartialPivLU<Matrix> factors_;
  StepCheck<max_states> check_;
};

}  // namespace stepwire::solve

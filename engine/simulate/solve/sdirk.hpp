#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/simulate/solve/forward_differences.hpp"
#include "engine/simulate/solve/step_check.hpp"
#include "engine/simulate/solve/step_report.hpp"

namespace stepwire::solve {

/// Singly diagonally implicit method of Alexander 1977 (SIAM J. Numer. Anal. 14(6)), for stiff plants that
/// are far from linear: three stages, order 3, L-stable. Each stage is solved by Newton's method. One matrix
/// serves until an iteration converges slowly; then it is recomputed. With `max_states` no memory is
/// allocated, and the results are the same to the last bit.
template <int max_states = Eigen::Dynamic>
class Sdirk {
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_states, 1>;

 public:
  explicit Sdirk(Eigen::Index states) : factors_(states), check_(states) {
    for (Vector* vector : {&start_, &base_, &slope_, &point_, &right_, &change_}) vector->setZero(states);
    for (Vector& stage : stages_) stage.setZero(states);
    jacobian_.setZero(states, states);
  }

  /// Integrates `x` over one step, from `time` to `end`. On entry `dot` must be the derivative at (time, x).
  /// evaluate() recomputes it for the present `x` and `*now`. A stage that is not solved, or a step whose
  /// error is beyond the tolerance, is written to `report`.
  template <class Evaluate>
  void advance(double* x_place, double* dot_place, double* now, double time, double end, double step,
               const StepReport& report, const Evaluate& evaluate) {
    Eigen::Map<Vector> x(x_place, start_.size());
    const Eigen::Map<const Vector> dot(dot_place, start_.size());
    if (!take(x, dot, now, time, end, step, evaluate)) return fail(x, report);
    if (report) check(x, dot, now, time, end, step, report, evaluate);
  }

  /// Attempts a step and estimates its error, for a step size controller.
  template <class X, class Dot, class Evaluate>
  bool attempt(X& x, Dot& dot, double* now, double time, double end, double step, double*,
               const Evaluate& evaluate) {
    if (!take(x, dot, now, time, end, step, evaluate)) return false;
    estimate();
    return change_.allFinite();
  }
  const Vector& error() const { return change_; }
  bool ends_with_slope() const { return false; }
  static constexpr double first_order = 3.0;
  /// Returns the order of the last attempt, for the choice of the next step size.
  double order() const { return 3.0; }

  /// Returns the states at the start of the last step.
  const double* start() const { return start_.data(); }

 private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_states, max_states>;

  static constexpr int max_corrections = 40;  // per stage
  static constexpr double slow = 0.1;      // ratio of successive corrections from which convergence is slow
  static constexpr double goal = 1e-12;    // largest final correction, relative to the states
  static constexpr double at_rest = 1e-6;  // the same if rounding prevents smaller corrections
  static constexpr double smallest_size = 1e-6;

  static constexpr double gamma = 0.43586652150845899942;  // middle root of 6 g^3 - 18 g^2 + 9 g - 1 = 0
  static constexpr double middle = (1.0 + gamma) / 2.0;
  static constexpr double b1 = -(6.0 * gamma * gamma - 16.0 * gamma + 1.0) / 4.0;
  static constexpr double b2 = (6.0 * gamma * gamma - 20.0 * gamma + 5.0) / 4.0;
  static constexpr double a[3][2] = {{0.0, 0.0}, {(1.0 - gamma) / 2.0, 0.0}, {b1, b2}};
  /// Weights of order 2 on the first two stages, for the error estimate.
  static constexpr double second = (0.5 - gamma) / (middle - gamma);

  /// Computes the stages. Returns false if one is not solved.
  template <class X, class Dot, class Evaluate>
  bool take(X& x, const Dot& dot, double* now, double time, double end, double step,
            const Evaluate& evaluate) {
    start_ = x;
    *now = time;
    slope_ = dot;
    renew(x, dot, step, evaluate);
    const double times[] = {time + gamma * step, time + middle * step, end};
    for (int stage = 0; stage < 3; ++stage) {
      base_ = start_;
      for (int before = 0; before < stage; ++before) base_ += a[stage][before] * stages_[before];
      *now = times[stage];
      if (!solve(x, dot, step, evaluate)) return false;
      stages_[stage] = (x - base_) / gamma;
    }
    return true;
  }

  /// Computes a new matrix at x, where the derivative is slope_.
  template <class X, class Dot, class Evaluate>
  void renew(X& x, const Dot& dot, double step, const Evaluate& evaluate) {
    point_ = x;
    forward_differences(jacobian_, x, dot, point_, slope_, step, evaluate);
    jacobian_ *= -step * gamma;
    jacobian_.diagonal().array() += 1.0;
    factors_.compute(jacobian_);
  }

  /// Solves x = base_ + step gamma f(x), starting at the present x. Returns false without a solution. A
  /// correction with an old matrix that is hardly smaller than the last one is not applied, since it may lead
  /// to another solution.
  template <class X, class Dot, class Evaluate>
  bool solve(X& x, const Dot& dot, double step, const Evaluate& evaluate) {
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < max_corrections; ++i) {
      evaluate();
      slope_ = dot;
      right_ = base_ + (step * gamma) * slope_ - x;
      double size = correct(x);
      const bool is_slow = size > slow * before;
      if (is_slow) {
        renew(x, dot, step, evaluate);
        size = correct(x);
      }
      if (!std::isfinite(size)) return false;
      // At a kink corrections may alternate between its sides; halving them converges.
      if (size > 0.5 * before) change_ *= 0.5;
      x += change_;
      // Rounding may prevent smaller corrections.
      if (size <= goal || (is_slow && size > slow * before && size <= at_rest)) return true;
      before = size;
    }
    return false;
  }

  /// Computes the correction of x with the matrix. Returns its size relative to the states.
  template <class X>
  double correct(const X& x) {
    change_ = factors_.solve(right_);
    double size = 0.0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double part =
          std::abs(change_[i]) / std::max({std::abs(x[i]), std::abs(start_[i]), smallest_size});
      if (!std::isfinite(part)) return part;
      size = std::max(size, part);
    }
    return size;
  }

  template <class X>
  void fail(const X& x, const StepReport& report) {
    if (!report) return;
    WorstError worst;
    for (Eigen::Index i = 0; i < x.size(); ++i) worst.add(change_[i], std::abs(start_[i]), i);
    report.write(StepReport::unsolved, worst.size, worst.state);
  }

  /// Estimates the error by the difference to the weights of order 2. One more solution with the matrix
  /// removes infinitely fast components, which are no error of the next step.
  void estimate() {
    right_ = (1.0 - second - b1) * stages_[0] + (second - b2) * stages_[1] - gamma * stages_[2];
    change_ = factors_.solve(right_);
  }

  template <class X, class Dot, class Evaluate>
  void check(X& x, const Dot& dot, double* now, double time, double end, double step,
             const StepReport& report, const Evaluate& evaluate) {
    estimate();
    WorstError own;
    for (Eigen::Index i = 0; i < start_.size(); ++i)
      own.add(right_[i], std::max(std::abs(start_[i]), std::abs(x[i])), i);
    if (!(own.size > report.tolerance)) return;
    const WorstError found =
        check_.error(x, const_cast<double*>(dot.data()), start_, now, time, end, step, evaluate);
    if (found.size > report.tolerance) report.write(StepReport::inaccurate, found.size, found.state);
  }

  Vector start_, base_, slope_, point_, right_, change_;
  Vector stages_[3];  ///< derivatives times the step
  Matrix jacobian_;
  Eigen::PartialPivLU<Matrix> factors_;
  StepCheck<max_states> check_;
};

}  // namespace stepwire::solve

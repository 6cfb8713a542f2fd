#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "engine/simulate/solve/forward_differences.hpp"

namespace stepwire::solve {

/// Attempts a step of RODAS (Hairer and Wanner, Solving ODEs II, IV.7), a linearly implicit method of order 4
/// with an estimate of order 3. It has six stages, is L-stable and stiffly accurate. The Jacobian by forward
/// differences costs one evaluation for each state and step.
template <int max_states>
class Rodas {
 public:
  explicit Rodas(Eigen::Index states) : factors_(states) {
    for (Vector* vector : {&start_, &slope_, &slope_time_, &right_}) vector->setZero(states);
    for (Vector& stage : stages_) stage.setZero(states);
    jacobian_.setZero(states, states);
  }

  template <class X, class Dot, class Evaluate>
  bool attempt(X& x, Dot& dot, double* now, double time, double end, double step, double*,
               const Evaluate& evaluate) {
    start_ = x;
    slope_ = dot;
    differentiate(x, dot, now, time, step, evaluate);
    for (int stage = 0; stage < stage_count; ++stage) {
      if (stage > 0) {
        for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = start_[i] + sum(i, a[stage], stage);
        *now = c[stage] == 1.0 ? end : time + c[stage] * step;
        evaluate();
      }
      for (Eigen::Index i = 0; i < x.size(); ++i)
        right_[i] = dot[i] + sum(i, coupling[stage], stage) / step + step * d[stage] * slope_time_[i];
      stages_[stage] = factors_.solve(right_);
    }
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += stages_[stage_count - 1][i];
    return x.allFinite() && stages_[stage_count - 1].allFinite();
  }
  /// Returns the last stage, which is the difference to the method of order 3.
  const auto& error() const { return stages_[stage_count - 1]; }
  bool ends_with_slope() const { return false; }
  static constexpr double first_order = 4.0;
  /// Returns the order of the last attempt, for the choice of the next step size.
  double order() const { return 4.0; }

 private:
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_states, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_states, max_states>;

  static constexpr int stage_count = 6;
  static constexpr double gamma = 0.25;
  static constexpr double c[stage_count] = {0.0, 0.386, 0.21, 0.63, 1.0, 1.0};
  static constexpr double d[stage_count] = {0.25, -0.1043, 0.1035, -0.03620000000000023, 0.0, 0.0};
  static constexpr double a[stage_count][stage_count] = {
      {},
      {1.544},
      {0.9466785280815826, 0.2557011698983284},
      {3.314825187068521, 2.896124015972201, 0.9986419139977817},
      {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
      {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1.0}};
  static constexpr double coupling[stage_count][stage_count] = {
      {},
      {-5.6688},
      {-2.430093356833875, -0.2063599157091915},
      {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
      {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
      {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}};

  double sum(Eigen::Index i, const double* weights, int count) const {
    double sum = 0.0;
    for (int stage = 0; stage < count; ++stage) sum += weights[stage] * stages_[stage][i];
    return sum;
  }

  /// Computes the matrix 1 / (step gamma) - J, and the partial derivative of `dot` with respect to time.
  template <class X, class Dot, class Evaluate>
  void differentiate(X& x, Dot& dot, double* now, double time, double step, const Evaluate& evaluate) {
    *now = time;
    forward_differences(jacobian_, x, dot, start_, slope_, step, evaluate);
    jacobian_ = -jacobian_;
    jacobian_.diagonal().array() += 1.0 / (step * gamma);
    factors_.compute(jacobian_);
    differentiate_by_time(dot, now, time, step, evaluate);
    dot = slope_;
  }
  /// A difference of two evaluations would reduce the order to 2, so three are combined.
  template <class Dot, class Evaluate>
  void differentiate_by_time(Dot& dot, double* now, double time, double step, const Evaluate& evaluate) {
    const double near = time + 0.001 * step, far = time + 0.002 * step, a = near - time, b = far - time;
    slope_time_.setZero();
    if (!(near > time && far > near)) return;
    *now = near;
    evaluate();
    slope_time_ = (dot - slope_) * (b / (a * (b - a)));
    *now = far;
    evaluate();
    slope_time_ -= (dot - slope_) * (a / (b * (b - a)));
  }

  Vector start_, slope_, slope_time_, right_;
  Vector stages_[stage_count];
  Matrix jacobian_;
  Eigen::PartialPivLU<Matrix> factors_;
};

}  // namespace stepwire::solve

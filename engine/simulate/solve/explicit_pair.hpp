#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

namespace stepwire::solve {

/// Weights of a pair of explicit Runge-Kutta methods. The last stage is the derivative at the end of the step
/// and the first stage of the next one (FSAL).
struct BogackiShampinePair {
  static constexpr int stages = 4;
  static constexpr double order = 3.0;
  static constexpr double stability = 2.5;
  static constexpr double c[stages] = {0.0, 1.0 / 2, 3.0 / 4, 1.0};
  static constexpr double a[stages][stages] = {{}, {1.0 / 2}, {0.0, 3.0 / 4}, {2.0 / 9, 1.0 / 3, 4.0 / 9}};
  static constexpr double error[stages] = {2.0 / 9 - 7.0 / 24, 1.0 / 3 - 1.0 / 4, 4.0 / 9 - 1.0 / 3,
                                           -1.0 / 8};
};

/// Dormand and Prince 1980, J. Comput. Appl. Math. 6(1).
struct DormandPrincePair {
  static constexpr int stages = 7;
  static constexpr double order = 5.0;
  static constexpr double stability = 3.25;
  static constexpr double c[stages] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
  static constexpr double a[stages][stages] = {
      {},
      {1.0 / 5},
      {3.0 / 40, 9.0 / 40},
      {44.0 / 45, -56.0 / 15, 32.0 / 9},
      {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
      {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
      {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static constexpr double error[stages] = {71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                           -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
};

/// Attempts a step of such a pair and estimates its error.
template <class Pair, int max_states>
class ExplicitPair {
 public:
  explicit ExplicitPair(Eigen::Index states) {
    for (Vector* vector : {&start_, &error_, &last_point_}) vector->setZero(states);
    for (Vector& slope : slopes_) slope.setZero(states);
  }

  template <class X, class Dot, class Evaluate>
  bool attempt(X& x, Dot& dot, double* now, double time, double end, double step, double*,
               const Evaluate& evaluate) {
    start_ = x;
    slopes_[0] = dot;
    for (int stage = 1; stage < Pair::stages; ++stage) {
      if (stage == Pair::stages - 1) last_point_ = x;
      for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = start_[i] + step * sum(i, Pair::a[stage], stage);
      *now = Pair::c[stage] == 1.0 ? end : time + Pair::c[stage] * step;
      evaluate();
      slopes_[stage] = dot;
    }
    for (Eigen::Index i = 0; i < x.size(); ++i) error_[i] = step * estimate(i);
    return true;
  }
  const auto& error() const { return error_; }
  bool ends_with_slope() const { return true; }
  static constexpr double first_order = Pair::order;
  /// Returns the order of the last attempt, for the choice of the next step size.
  double order() const { return Pair::order; }

  /// Returns the step times the largest decay rate, relative to the stability bound. It is estimated from the
  /// last two stages, which have the same time (Hairer and Wanner, Solving ODEs II, IV.2).
  template <class X>
  double stiffness(const X& x, double step) const {
    double slopes = 0.0, points = 0.0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double slope = slopes_[Pair::stages - 1][i] - slopes_[Pair::stages - 2][i],
                   point = x[i] - last_point_[i];
      slopes += slope * slope;
      points += point * point;
    }
    return points > 0.0 ? step * std::sqrt(slopes / points) / Pair::stability : 0.0;
  }

 private:
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_states, 1>;

  double sum(Eigen::Index i, const double* weights, int count) const {
    double sum = 0.0;
    for (int stage = 0; stage < count; ++stage) sum += weights[stage] * slopes_[stage][i];
    return sum;
  }

  /// Returns the error divided by the step. With two estimates, the finer one is weighted by its ratio to the
  /// coarser one, so that it decreases with the order of the method.
  double estimate(Eigen::Index i) const {
    const double fine = sum(i, Pair::error, Pair::stages);
    if constexpr (requires { Pair::coarse_error; }) {
      const double coarse = sum(i, Pair::coarse_error, Pair::stages);
      const double ratio = 0.1 * coarse / fine;  // the squares of the two could underflow to 0
      return fine == 0.0 ? 0.0 : fine / std::sqrt(1.0 + ratio * ratio);
    }
    return fine;
  }

  Vector start_, error_, last_point_;
  Vector slopes_[Pair::stages];
};

template <int max_states>
using BogackiShampine = ExplicitPair<BogackiShampinePair, max_states>;
template <int max_states>
using DormandPrince = ExplicitPair<DormandPrincePair, max_states>;

}  // namespace stepwire::solve

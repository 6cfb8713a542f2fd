#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "engine/base/math/elementary.hpp"
#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/forward_differences.hpp"

namespace stepwire::solve {

/// Attempts a step of Radau IIA of order 5 (Hairer and Wanner, Solving ODEs II, IV.8), with three implicit
/// stages, L-stable and stiffly accurate.
///
/// Rosenbrock methods need a new Jacobian for each step, and a wrong one reduces their order. Radau solves
/// its stages by Newton's method, so a Jacobian is reusable as long as corrections shrink fast, and its
/// rounding does no harm. A change of variables (the eigenvectors of the method's matrix) splits the system
/// of 3 n unknowns into one of n real and one of n complex unknowns. The initial guess of the stages is the
/// extrapolated polynomial of the previous step. A step costs three evaluations for each of usually two to
/// four corrections, and one for each state with a new Jacobian.
template <int max_states>
class Radau {
 public:
  explicit Radau(Eigen::Index states) : factors_(states), complex_factors_(states) {
    for (Vector* vector : {&start_, &slope_, &right_, &error_, &weight_}) vector->setZero(states);
    for (int i = 0; i < 3; ++i)
      for (Vector* vector : {&stages_[i], &turned_[i], &slopes_[i], &past_[i]}) vector->setZero(states);
    complex_right_.setZero(states);
    complex_change_.setZero(states);
    jacobian_.setZero(states, states);
    matrix_.setZero(states, states);
    complex_matrix_.setZero(states, states);
  }

  /// Resets all data of earlier calls.
  void begin(const ErrorControl& control, double*, double, double) {
    control_ = control;
    // The estimate has order 3 and the method order 5: the smaller the tolerance, the more the estimate
    // exceeds the error. The powers are fitted to the problems of bench/solvers.
    scale_ = std::min(1.0, 3.0 * fn::pow(control.relative, 0.24));
    const double relative = control.relative / scale_;
    goal_ = std::max(10.0 * epsilon / relative, std::min(0.03, fn::pow(relative, 0.43)));
    is_here_ = is_good_ = has_past_ = is_solved_ = false;
    factored_step_ = rate_ = 0.0;
    tried_ = std::numeric_limits<double>::quiet_NaN();
  }

  template <class X, class Dot, class Evaluate>
  bool attempt(X& x, Dot& dot, double* now, double time, double end, double step, double*,
               const Evaluate& evaluate) {
    start_ = x;
    slope_ = dot;
    is_again_ = time == tried_;
    if (!is_again_) begin_step(time);
    if (!is_here_ && !is_good_) differentiate(x, dot, now, time, step, evaluate);
    is_solved_ = iterate(x, dot, now, time, end, step, evaluate);
    if (!is_solved_ && !is_here_) {
      differentiate(x, dot, now, time, step, evaluate);
      is_solved_ = iterate(x, dot, now, time, end, step, evaluate);
    }
    tried_step_ = step;
    is_good_ = is_solved_ && rate_ <= good_rate;
    if (!is_solved_) return false;
    estimate(x, dot, now, time, step, evaluate);
    x = start_ + stages_[2];
    return x.allFinite() && error_.allFinite();
  }
  const auto& error() const { return error_; }
  bool ends_with_slope() const { return false; }
  /// A slightly longer step is not worth new factors.
  bool keeps_step() const { return true; }
  static constexpr double first_order = 4.0;
  /// Returns the order of the last attempt, for the choice of the next step size.
  double order() const { return 4.0; }

 private:
  using Complex = std::complex<double>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_states, 1>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_states, max_states>;
  using ComplexVector = Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, max_states, 1>;
  using ComplexMatrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, max_states, max_states>;

  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr int max_corrections = 8;
  static constexpr double good_rate = 5e-3;  ///< contraction rate up to which a Jacobian is reused
  static constexpr double root6 = 2.449489742783178098;
  static constexpr double c[3] = {(4.0 - root6) / 10.0, (4.0 + root6) / 10.0, 1.0};
  /// Eigenvalues of the inverse of the method's matrix: one real, one complex pair.
  static constexpr double real = 3.6378342527444957322;
  static constexpr double pair[2] = {2.6810828736277521339, 3.0504301992474105694};
  /// Columns are the real eigenvector, and real and imaginary part of a complex one.
  static constexpr double from_turned[3][3] = {
      {0.094438762488975241487, -0.14125529502095420843, -0.030029194105147424492},
      {0.25021312296533331138, 0.204129352293799932, 0.3829421127572619378},
      {1.0, 1.0, 0.0}};
  static constexpr double to_turned[3][3] = {
      {4.1787185915519047273, 0.32768282076106238708, 0.52337644549944954804},
      {-4.1787185915519047273, -0.32768282076106238708, 0.47662355450055045196},
      {-0.50287263494578687595, 2.5719269498556054292, -0.59603920482822492497}};
  static constexpr double error_weights[3] = {-(13.0 + 7.0 * root6) / 3.0, (-13.0 + 7.0 * root6) / 3.0,
                                              -1.0 / 3.0};

  static double sum(const double (&weights)[3], const Vector (&of)[3], Eigen::Index i) {
    return weights[0] * of[0][i] + weights[1] * of[1][i] + weights[2] * of[2][i];
  }

  /// Stores the stages of the last step, which was accepted, for the guess of the next.
  void begin_step(double time) {
    has_past_ = is_solved_;
    if (has_past_)
      for (int i = 0; i < 3; ++i) past_[i] = stages_[i];
    past_step_ = tried_step_;
    is_here_ = false;
    tried_ = time;
    for (Eigen::Index i = 0; i < start_.size(); ++i)
      weight_[i] = (control_.absolute + control_.relative * std::abs(start_[i])) / scale_;
  }

  template <class X, class Dot, class Evaluate>
  void differentiate(X& x, const Dot& dot, double* now, double time, double step, const Evaluate& evaluate) {
    x = start_;
    *now = time;
    forward_differences(jacobian_, x, dot, start_, slope_, step, evaluate);
    is_here_ = true;
    factored_step_ = 0.0;
  }

  void factor(double step) {
    matrix_ = -jacobian_;
    matrix_.diagonal().array() += real / step;
    factors_.compute(matrix_);
    complex_matrix_ = -jacobian_.template cast<Complex>();
    complex_matrix_.diagonal().array() += Complex(pair[0] / step, pair[1] / step);
    complex_factors_.compute(complex_matrix_);
    factored_step_ = step;
  }

  /// Extrapolates the polynomial of the last step to the stages.
  void predict(double step) {
    const double ratio = has_past_ ? step / past_step_ : 0.0;
    for (int k = 0; k < 3; ++k) {
      const double s = 1.0 + ratio * c[k];
      double weights[3] = {};
      for (int j = 0; j < 3 && has_past_; ++j) {
        weights[j] = s / c[j];
        for (int m = 0; m < 3; ++m)
          if (m != j) weights[j] *= (s - c[m]) / (c[j] - c[m]);
      }
      weights[2] -= has_past_ ? 1.0 : 0.0;
      for (Eigen::Index i = 0; i < start_.size(); ++i)
        stages_[k][i] = has_past_ ? sum(weights, past_, i) : 0.0;
    }
    for (int k = 0; k < 3; ++k)
      for (Eigen::Index i = 0; i < start_.size(); ++i) turned_[k][i] = sum(to_turned[k], stages_, i);
  }

  /// Solves for the stages by Newton's method. Returns false if the corrections do not shrink fast enough.
  template <class X, class Dot, class Evaluate>
  bool iterate(X& x, const Dot& dot, double* now, double time, double end, double step,
               const Evaluate& evaluate) {
    if (factored_step_ != step) factor(step);
    predict(step);
    double before = 0.0;
    rate_ = 0.0;
    for (int k = 0; k < max_corrections; ++k) {
      for (int stage = 0; stage < 3; ++stage) {
        x = start_ + stages_[stage];
        *now = stage == 2 ? end : time + c[stage] * step;
        evaluate();
        slopes_[stage] = dot;
      }
      const double size = correct(step);
      if (!std::isfinite(size)) return false;
      if (k > 0) rate_ = size / before;
      if (rate_ >= 0.99) return false;
      const double left = k > 0 ? rate_ / (1.0 - rate_) : 1.0;
      if (left * size <= goal_) return true;
      if (left * size * fn::pow(rate_, max_corrections - 2 - k) > goal_ && k > 0) return false;
      before = size;
    }
    return false;
  }

  /// Applies one correction to the stages. Returns its size relative to the tolerances.
  double correct(double step) {
    for (Eigen::Index i = 0; i < start_.size(); ++i) {
      const double f1 = sum(to_turned[1], slopes_, i), f2 = sum(to_turned[2], slopes_, i);
      right_[i] = sum(to_turned[0], slopes_, i) - real / step * turned_[0][i];
      complex_right_[i] = Complex(f1 - (pair[0] * turned_[1][i] - pair[1] * turned_[2][i]) / step,
                                  f2 - (pair[1] * turned_[1][i] + pair[0] * turned_[2][i]) / step);
    }
    error_ = factors_.solve(right_);
    complex_change_ = complex_factors_.solve(complex_right_);
    double squares = 0.0;
    for (Eigen::Index i = 0; i < start_.size(); ++i) {
      const double changes[3] = {error_[i], complex_change_[i].real(), complex_change_[i].imag()};
      for (int k = 0; k < 3; ++k) {
        turned_[k][i] += changes[k];
        squares += changes[k] / weight_[i] * (changes[k] / weight_[i]);
      }
      for (int k = 0; k < 3; ++k) stages_[k][i] = sum(from_turned[k], turned_, i);
    }
    return std::sqrt(squares / (3.0 * static_cast<double>(std::max<Eigen::Index>(start_.size(), 1))));
  }

  /// Estimates the error by the difference to a method of order 3. A too large estimate is filtered with the
  /// derivative at the corrected point, which removes infinitely fast components. That is done in the first
  /// step and after a rejection alone: a fast component that follows a slow input has an error of order 3,
  /// which the filter hides (Prothero and Robinson 1974).
  template <class X, class Dot, class Evaluate>
  void estimate(X& x, const Dot& dot, double* now, double time, double step, const Evaluate& evaluate) {
    const auto solve = [&](const auto& slope) {
      for (Eigen::Index i = 0; i < start_.size(); ++i)
        right_[i] = slope[i] + sum(error_weights, stages_, i) / step;
      error_ = factors_.solve(right_);
    };
    solve(slope_);
    if (!(norm() < 1.0) && (is_again_ || !has_past_)) {
      x = start_ + error_;
      *now = time;
      evaluate();
      solve(dot);
    }
    error_ *= scale_;
  }
  double norm() const {
    double squares = 0.0;
    for (Eigen::Index i = 0; i < start_.size(); ++i)
      squares += error_[i] / weight_[i] * (error_[i] / weight_[i]);
    return std::sqrt(squares / static_cast<double>(std::max<Eigen::Index>(start_.size(), 1)));
  }

  ErrorControl control_;
  double scale_ = 1.0, goal_ = 0.0;  ///< tolerance factors: estimate, last correction
  bool is_here_ = false;             ///< true if the Jacobian is of this start
  bool is_good_ = false;             ///< true if the Jacobian is reusable
  bool is_again_ = false;            ///< true if the last attempt began here, too
  bool is_solved_ = false;           ///< true if the last attempt was solved
  bool has_past_ = false;
  double rate_ = 0.0;  ///< contraction rate of the corrections
  double factored_step_ = 0.0, tried_step_ = 0.0, past_step_ = 0.0, tried_ = 0.0;
  Vector start_, slope_, right_, error_, weight_;
  Vector stages_[3], turned_[3], slopes_[3], past_[3];
  ComplexVector complex_right_, complex_change_;
  Matrix jacobian_, matrix_;
  ComplexMatrix complex_matrix_;
  Eigen::PartialPivLU<Matrix> factors_;
  Eigen::PartialPivLU<ComplexMatrix> complex_factors_;
};

}  // namespace stepwire::solve

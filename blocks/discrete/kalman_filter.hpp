#pragma once

#include "engine/model/block/linear_system.hpp"

namespace stepwire {

/// Kalman filter of x[k+1] = A x + B u + w, y = C x + D u + v, with w of covariance Q and v of R.
struct KalmanFilter : LinearSystem {
  Matrix Q, R, P0;
  Input<> measured{};
  Output<> estimate{}, innovation{};
  DiscreteState<> x{};           // prediction before this tick's measurement
  DiscreteState<> P{};           // covariance of the prediction
  DiscreteState<> K{};           // gain of this tick
  DiscreteState<> first_gain{};  // gain of the first tick
  DiscreteState<> work{};        // memory for the next covariance and gain
  Diagnostic not_positive{};
  Time t{};

  void outputs() {
    innovation = measured;
    if (resetting()) {
      correct(Targets{*this}, first_gain);
    } else {
      correct(x, K);
    }
  }

  void update() {
    const bool now = resetting();
    if (now) begin();
    remember_reset();
    predict_state();
    if (!(predict_covariance() && find_gain())) not_positive.raise(t);
  }

  void start() {
    home = x;
    begin();
    if (!find_gain() && is_uncertain()) not_positive.raise(t);
    first_gain = K;
  }

  void configure(Configure& is);
  static void declare(Declare<KalmanFilter>& is);

 private:
  Index states() const { return A.rows(); }
  Index outputs_count() const { return C.rows(); }
  dense::View covariance() const { return {P.elements(), states()}; }
  dense::View gain() const { return {K.elements(), states()}; }

  /// Sets the initial covariance and gain; within start() the gain is computed afterwards.
  void begin() {
    for (Index k = 0; k < P.size(); ++k) P[k] = P0.elements().empty() ? 0.0 : P0.elements()[k];
    K = first_gain;
  }

  /// False if the initial covariance is 0. The gain is then 0, also of a measurement without noise.
  bool is_uncertain() const {
    for (Index k = 0; k < P.size(); ++k)
      if (P[k] != 0.0) return true;
    return false;
  }

  template <class Expected, class Gain>
  void correct(const Expected& expected, const Gain& gain) {
    dense::add(C, expected, innovation, -1.0);
    if (direct) dense::add(D, u, innovation, -1.0);
    const Index n = states();
    for (Index i = 0; i < n; ++i) {
      double sum = expected[i];
      for (Index j = 0; j < innovation.size(); ++j) sum += gain[j * n + i] * innovation[j];
      estimate[i] = sum;
    }
  }

  /// Computes x = A estimate + B u from the estimate of outputs().
  void predict_state() {
    x = 0.0;
    dense::add(A, estimate, x);
    if (u.connected()) dense::add(B, u, x);
  }

  /// Computes P = A ((I - K C) P (I - K C)' + K R K') A' + Q, in Joseph's form, which stays symmetric and
  /// positive.
  bool predict_covariance() {
    const Index n = states(), p = outputs_count();
    const Lane one = work.elements(), two = one + n * n;
    const auto kept = [&](Index i, Index j) {
      double sum = i == j ? 1.0 : 0.0;
      for (Index k = 0; k < p; ++k) sum -= K[k * n + i] * C(k, j);
      return sum;
    };
    dense::multiply(n, n, n, A, kept, one);
    const dense::View moved{one, n};
    dense::multiply(n, n, n, moved, covariance(), two);
    const dense::View half{two, n};
    dense::multiply(n, n, n, half, dense::transposed(moved), P.elements());
    dense::multiply(n, n, p, A, gain(), one);
    const dense::View noise{one, n};
    dense::multiply(n, p, p, noise, R, two);
    const dense::View weighted{two, n};
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i) {
        double sum = Q(i, j);
        for (Index k = 0; k < p; ++k) sum += weighted(i, k) * noise(j, k);
        P[j * n + i] += sum;
      }
    return make_symmetric();
  }

  bool make_symmetric() {
    const Index n = states();
    bool positive = true;
    for (Index j = 0; j < n; ++j) {
      positive = positive && P[j * n + j] >= 0.0;
      for (Index i = 0; i < j; ++i) P[i * n + j] = P[j * n + i] = 0.5 * (P[i * n + j] + P[j * n + i]);
    }
    return positive;
  }

  /// Computes K = P C' (C P C' + R)^-1.
  bool find_gain() {
    const Index n = states(), p = outputs_count();
    const Lane crossed = work.elements(), sum = crossed + n * p;
    dense::multiply(n, n, p, covariance(), dense::transposed(C), crossed);
    dense::multiply(p, n, p, C, dense::View{crossed, n}, sum);
    for (Index k = 0; k < p * p; ++k) sum[k] += R.elements()[k];
    if (!dense::factorize(p, sum)) return false;
    for (Index k = 0; k < n * p; ++k) K[k] = crossed[k];
    for (Index i = 0; i < n; ++i) dense::solve_factorized(p, sum, K.elements() + i, n);
    return true;
  }
};

}  // namespace stepwire

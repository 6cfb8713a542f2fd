#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"
#include "engine/block/limits.hpp"

namespace stepwire {

/// Discrete PID controller in parallel form: y = kp e + I + kd D at its ticks, within limits.
struct DiscretePID {
  enum class Method { forward_euler, backward_euler, trapezoidal };
  enum class AntiWindup { none, clamping, back_calculation };

  PerElement kp = 1.0, ki = 0.0, kd = 0.0, tau = 0.0;
  Method method = Method::forward_euler;
  PerElement lower = -unlimited, upper = unlimited;
  PerElement integral_lower = -unlimited, integral_upper = unlimited;
  AntiWindup anti_windup = AntiWindup::clamping;
  PerElement tracking = 1.0, weight_p = 1.0, weight_d = 1.0;
  Input<> u{}, reference{};
  Output<> y{};
  DiscreteState<> integral{}, rate{}, last{};
  Period period{};

  double before = 0.0, after = 1.0;  // shares of ki T e that count before and after the output is given

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = limited(wanted(i), i);
  }

  void update() {
    for (Eigen::Index i = 0; i < integral.size(); ++i) {
      const double next = next_integral(i);
      rate.coeffRef(i) = slope(i);
      last.coeffRef(i) = weighted(weight_d, i);
      integral.coeffRef(i) = next;
    }
  }

  void configure(Configure& is);
  static void declare(Declare<DiscretePID>& is);

 private:
  /// The error with only a share of the reference in it.
  double weighted(const PerElement& weight, Eigen::Index i) const {
    return reference.connected() ? u.coeff(i) - (1.0 - weight.coeff(i)) * reference.coeff(i) : u.coeff(i);
  }
  double limited(double number, Eigen::Index i) const {
    return std::clamp(number, lower.coeff(i), upper.coeff(i));
  }
  double held(double number, Eigen::Index i) const {
    return std::clamp(number, integral_lower.coeff(i), integral_upper.coeff(i));
  }
  double increment(Eigen::Index i) const { return ki.coeff(i) * period * u.coeff(i); }
  double integral_now(Eigen::Index i) const {
    return before == 0.0 ? integral.coeff(i) : held(integral.coeff(i) + before * increment(i), i);
  }
  /// Backward difference of tau D' + D = e'; without a filter that is (e[k] - e[k-1]) / T.
  double slope(Eigen::Index i) const {
    const double change = weighted(weight_d, i) - last.coeff(i);
    return (tau.coeff(i) * rate.coeff(i) + change) / (tau.coeff(i) + period);
  }
  double wanted(Eigen::Index i) const {
    return kp.coeff(i) * weighted(weight_p, i) + integral_now(i) + kd.coeff(i) * slope(i);
  }

  double next_integral(Eigen::Index i) const {
    const double want = wanted(i), give = limited(want, i), more = increment(i);
    if (anti_windup == AntiWindup::clamping && (want - give) * more > 0.0) return integral.coeff(i);
    double next = integral_now(i) + after * more;
    if (anti_windup == AntiWindup::back_calculation) next += period / tracking.coeff(i) * (give - want);
    return held(next, i);
  }
};

}  // namespace stepwire

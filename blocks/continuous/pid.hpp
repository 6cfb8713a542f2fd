#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"
#include "engine/block/limits.hpp"

namespace stepwire {

/// Continuous PID controller in parallel form: kp e + ki / s e + kd s / (tau s + 1) e, within limits.
struct PID {
  enum class AntiWindup { none, clamping, back_calculation };

  PerElement kp = 1.0, ki = 0.0, kd = 0.0, tau = 0.01;
  PerElement lower = -unlimited, upper = unlimited;
  PerElement integral_lower = -unlimited, integral_upper = unlimited;
  AntiWindup anti_windup = AntiWindup::clamping;
  PerElement tracking = 1.0, weight_p = 1.0, weight_d = 1.0;
  Input<> u{}, reference{};
  Output<> y{};
  State<> integral{}, filter{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = limited(wanted(i), i);
  }

  void derivatives() {
    for (Eigen::Index i = 0; i < integral.size(); ++i) {
      integral.dot.coeffRef(i) = integral_rate(i);
      filter.dot.coeffRef(i) = kd.coeff(i) == 0.0 ? 0.0 : slope(i);
    }
  }

  /// Runs only where the integral part has limits of its own.
  void update() {
    for (Eigen::Index i = 0; i < integral.size(); ++i)
      integral.coeffRef(i) = std::clamp(integral.coeff(i), integral_lower.coeff(i), integral_upper.coeff(i));
  }

  void configure(Configure& is);
  static void declare(Declare<PID>& is);

 private:
  /// The error with only a share of the reference in it.
  double weighted(const PerElement& weight, Eigen::Index i) const {
    return reference.connected() ? u.coeff(i) - (1.0 - weight.coeff(i)) * reference.coeff(i) : u.coeff(i);
  }
  double slope(Eigen::Index i) const { return (weighted(weight_d, i) - filter.coeff(i)) / tau.coeff(i); }
  double wanted(Eigen::Index i) const {
    const double sum = kp.coeff(i) * weighted(weight_p, i) + integral.coeff(i);
    return kd.coeff(i) == 0.0 ? sum : sum + kd.coeff(i) * slope(i);
  }
  double limited(double number, Eigen::Index i) const {
    return std::clamp(number, lower.coeff(i), upper.coeff(i));
  }

  double integral_rate(Eigen::Index i) const {
    double rate = ki.coeff(i) * u.coeff(i);
    const double want = wanted(i), give = limited(want, i);
    if (anti_windup == AntiWindup::clamping && (want - give) * rate > 0.0) return 0.0;
    if (anti_windup == AntiWindup::back_calculation) rate += (give - want) / tracking.coeff(i);
    const bool outward = (rate > 0.0 && integral.coeff(i) >= integral_upper.coeff(i)) ||
                         (rate < 0.0 && integral.coeff(i) <= integral_lower.coeff(i));
    return outward ? 0.0 : rate;
  }
};

}  // namespace stepwire

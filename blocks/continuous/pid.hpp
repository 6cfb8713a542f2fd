#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

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
    y.each([&](Index i) { return limited(wanted(i), i); });
  }

  void derivatives() {
    for (Index i = 0; i < integral.size(); ++i) {
      integral.dot[i] = integral_rate(i);
      filter.dot[i] = kd[i] == 0.0 ? 0.0 : slope(i);
    }
  }

  /// Runs only where the integral part has limits of its own.
  void update() {
    for (Index i = 0; i < integral.size(); ++i)
      integral[i] = std::clamp(integral[i], integral_lower[i], integral_upper[i]);
  }

  void configure(Configure& is);
  static void declare(Declare<PID>& is);

 private:
  /// The error with only a share of the reference in it.
  double weighted(const PerElement& weight, Index i) const {
    return reference.connected() ? u[i] - (1.0 - weight[i]) * reference[i] : u[i];
  }
  double slope(Index i) const { return (weighted(weight_d, i) - filter[i]) / tau[i]; }
  double wanted(Index i) const {
    const double sum = kp[i] * weighted(weight_p, i) + integral[i];
    return kd[i] == 0.0 ? sum : sum + kd[i] * slope(i);
  }
  double limited(double number, Index i) const { return std::clamp(number, lower[i], upper[i]); }

  double integral_rate(Index i) const {
    double rate = ki[i] * u[i];
    const double want = wanted(i), give = limited(want, i);
    if (anti_windup == AntiWindup::clamping && (want - give) * rate > 0.0) return 0.0;
    if (anti_windup == AntiWindup::back_calculation) rate += (give - want) / tracking[i];
    const bool outward =
        (rate > 0.0 && integral[i] >= integral_upper[i]) || (rate < 0.0 && integral[i] <= integral_lower[i]);
    return outward ? 0.0 : rate;
  }
};

}  // namespace stepwire

#pragma once

#include <algorithm>

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Discrete PID controller in parallel form: y = kp e + I + kd D at its ticks, within limits.
struct DiscretePID : Resettable {
  enum class Method { forward_euler, backward_euler, trapezoidal };
  enum class AntiWindup { none, clamping, back_calculation };

  PerElement kp = 1.0, ki = 0.0, kd = 0.0, tau = 0.0;
  Method method = Method::forward_euler;
  PerElement lower = -unlimited, upper = unlimited;
  PerElement integral_lower = -unlimited, integral_upper = unlimited;
  AntiWindup anti_windup = AntiWindup::clamping;
  PerElement tracking = 1.0, weight_p = 1.0, weight_d = 1.0;
  bool settled = true;
  Input<> u{}, reference{};
  Output<> y{};
  DiscreteState<> integral{}, rate{}, last{};
  DiscreteState<1> hand{};   // 1 while the command is given by hand
  DiscreteState<1> begun{};  // 1 after the first tick
  Period period{};

  double before = 0.0, after = 1.0;  // shares of ki T e that are added before and after the output
  PerElement per_time = 1.0;         // 1 / (tau + T), which is on the critical path
  bool plain = true;                 // true if only u and reference are used
  Input<> actual{}, manual{};
  Input<1> automatic{};

  void outputs() {
    y.each([&](Index i) { return by_hand() ? limited(manual[i], i) : limited(wanted(i), i); });
  }

  void update() {
    const bool manually = by_hand();
    integral.each([&](Index i) {
      const double change = slope(i), want = kp[i] * weighted(weight_p, i) + integral_now(i) + kd[i] * change;
      const double next = manually ? taken_over(i) : next_integral(want, i);
      rate[i] = change;
      last[i] = weighted(weight_d, i);
      return next;
    });
    begun = 1.0;
    if (plain) return;
    hand = manually ? 1.0 : 0.0;
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = integral; }
  void prepare() {
    per_time = tau.map([this](double filter) { return 1.0 / (filter + period); });
  }
  static void declare(Declare<DiscretePID>& is);

 private:
  bool by_hand() const { return !plain && manual.connected() && !(automatic > 0.0); }
  bool put_back() const { return !plain && resetting(); }
  /// True at the first tick after those by hand: the output is then still that of the hand.
  bool handed_over() const { return !plain && hand > 0.0 && !by_hand() && !put_back(); }
  double integral_before(Index i) const {
    return put_back() ? target(i) : handed_over() ? taken_over(i) : integral[i];
  }
  /// Returns the error with a weighted reference.
  double weighted(const PerElement& weight, Index i) const {
    return reference.connected() ? u[i] - (1.0 - weight[i]) * reference[i] : u[i];
  }
  double limited(double number, Index i) const { return std::clamp(number, lower[i], upper[i]); }
  double within(double number, Index i) const {
    return std::clamp(number, integral_lower[i], integral_upper[i]);
  }
  double increment(Index i) const { return ki[i] * period * u[i]; }
  double integral_now(Index i) const {
    return before == 0.0 || handed_over() ? integral_before(i)
                                          : within(integral_before(i) + before * increment(i), i);
  }
  /// Returns the backward difference of tau D' + D = e'; without a filter (e[k] - e[k-1]) / T.
  double slope(Index i) const {
    if (settled && (begun == 0.0 || put_back())) return 0.0;
    if (put_back()) return weighted(weight_d, i) * per_time[i];
    const double change = weighted(weight_d, i) - last[i];
    return (tau[i] * rate[i] + change) * per_time[i];
  }
  double wanted(Index i) const { return kp[i] * weighted(weight_p, i) + integral_now(i) + kd[i] * slope(i); }

  /// Returns the integral part with which the output is the manual command, for a bumpless transfer.
  double taken_over(Index i) const {
    return within(limited(manual[i], i) - kp[i] * weighted(weight_p, i) - kd[i] * slope(i), i);
  }

  double next_integral(double want, Index i) const {
    const double give = limited(want, i), more = increment(i);
    const bool stops = anti_windup == AntiWindup::clamping && (want - give) * more > 0.0;
    double next = stops ? integral_before(i) : integral_now(i) + after * more;
    if (actual.connected()) {
      next += period / tracking[i] * (actual[i] - give);
    } else if (stops) {
      return next;
    }
    if (anti_windup == AntiWindup::back_calculation) next += period / tracking[i] * (give - want);
    return within(next, i);
  }
};

}  // namespace stepwire

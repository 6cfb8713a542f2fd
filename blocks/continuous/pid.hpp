#pragma once

#include <algorithm>

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Continuous PID controller in parallel form: kp e + ki / s e + kd s / (tau s + 1) e, within limits.
struct PID : Resettable {
  enum class AntiWindup { none, clamping, back_calculation };

  PerElement kp = 1.0, ki = 0.0, kd = 0.0, tau = 0.01;
  PerElement lower = -unlimited, upper = unlimited;
  PerElement integral_lower = -unlimited, integral_upper = unlimited;
  AntiWindup anti_windup = AntiWindup::clamping;
  PerElement tracking = 1.0, weight_p = 1.0, weight_d = 1.0;
  bool settled = true;
  Input<> u{}, reference{}, actual{}, manual{};
  Input<1> automatic{};
  Output<> y{};
  State<> integral{}, filter{};
  DiscreteState<1> hand{};   // 1 in manual mode, as of the last instant
  DiscreteState<1> begun{};  // 1 after the first instant
  // Limit that the output wants to exceed, as of the last instant: 2 the upper and -2 the lower one, if so
  // since a tick; 1 and -1 after an event between two ticks; else 0.
  DiscreteState<> at_limit{};
  DiscreteState<> stop{};  // 1 if the integral part was at its upper and -1 at its lower limit then, else 0

  bool plain = true;  // true if only u and reference are used

  void outputs() {
    y.each([&](Index i) { return limited(hand > 0.0 ? manual[i] : wanted(i, here(i)), i); });
  }
  void outputs_at_instant() {
    y.each([&](Index i) { return limited(by_hand() ? manual[i] : wanted(i, at_instant(i)), i); });
  }

  void derivatives() {
    if (!plain && held()) {
      integral.derivative = 0.0;
      filter.derivative = 0.0;
      return;
    }
    for (Index i = 0; i < integral.size(); ++i) {
      integral.derivative[i] = hand > 0.0 ? 0.0 : integral_rate(i);
      filter.derivative[i] = kd[i] == 0.0 ? 0.0 : slope(i, here(i));
    }
  }

  void update_before_instant() {
    for (Index i = 0; held() && i < integral.size(); ++i) {
      const Parts parts = here(i);
      integral[i] = parts.integral;
      filter[i] = parts.filter;
    }
  }
  /// Runs only if the filter is settled, a limit is set, or `plain` is false.
  void update() {
    follow();
    for (Index i = 0; i < at_limit.size(); ++i) at_limit[i] = 2.0 * beyond(i);
  }
  void update_at_event() {
    follow();
    for (Index i = 0; i < at_limit.size(); ++i)
      if (at_limit[i] != 2.0 * beyond(i)) at_limit[i] = beyond(i);
  }

  /// An output that has met its limit between two ticks may leave it at the next tick. Where clamping makes
  /// the integral part slide along the limit, it would else meet and leave it without end.
  void crossings(Crossings& zero) const {
    Resettable::crossings(zero);
    zero.add_connected(automatic);
    for (Index i = 0; i < y.size(); ++i) zero.add(at_limit[i] == -1.0 ? 1.0 : command(i) - lower[i]);
    for (Index i = 0; i < y.size(); ++i) zero.add(at_limit[i] == 1.0 ? 1.0 : upper[i] - command(i));
    for (Index i = 0; i < y.size(); ++i)
      zero.add(stop[i] < 0.0 ? free_rate(i) : integral[i] - integral_lower[i]);
    for (Index i = 0; i < y.size(); ++i)
      zero.add(stop[i] > 0.0 ? -free_rate(i) : integral_upper[i] - integral[i]);
  }

  void configure(Configure& is);
  void start() { home = integral; }
  static void declare(Declare<PID>& is);

 private:
  /// States of the controller.
  struct Parts {
    double integral, filter;
  };

  void follow() {
    if (!plain) {
      take_over();
    } else if (settled && begun == 0.0) {
      for (Index i = 0; i < filter.size(); ++i) filter[i] = at_instant(i).filter;
    }
    begun = 1.0;
    for (Index i = 0; i < integral.size(); ++i) {
      integral[i] = std::clamp(integral[i], integral_lower[i], integral_upper[i]);
      stop[i] = integral[i] >= integral_upper[i] ? 1.0 : integral[i] <= integral_lower[i] ? -1.0 : 0.0;
    }
  }

  /// Returns the output without its limits.
  double command(Index i) const { return hand > 0.0 ? manual[i] : wanted(i, here(i)); }
  double beyond(Index i) const {
    const double now = command(i);
    return now > upper[i] ? 1.0 : now < lower[i] ? -1.0 : 0.0;
  }
  bool by_hand() const { return !plain && manual.connected() && !(automatic > 0.0); }
  /// Returns the states between instants; before the first update the derivative part is 0, unless its filter
  /// starts at 0.
  Parts here(Index i) const {
    if (!plain && held() && !(hand > 0.0)) return restarted(i);
    return {integral[i], settled && begun == 0.0 ? weighted(weight_d, i) : filter[i]};
  }
  /// Returns the states at an instant: after a reset the derivative part is 0, unless its filter starts at 0.
  Parts at_instant(Index i) const {
    const bool back = !plain && resetting();
    if (hand > 0.0 && !by_hand() && !back) return handed_over(i);
    return back ? restarted(i) : here(i);
  }
  Parts restarted(Index i) const { return {target(i), settled ? weighted(weight_d, i) : 0.0}; }
  /// Returns the states with which the controller begins at the output of the hand.
  Parts handed_over(Index i) const {
    const Parts now = here(i);
    return {limited(manual[i], i) - (wanted(i, now) - now.integral), now.filter};
  }
  /// Returns the error with a weighted reference.
  double weighted(const PerElement& weight, Index i) const {
    return reference.connected() ? u[i] - (1.0 - weight[i]) * reference[i] : u[i];
  }
  double slope(Index i, const Parts& parts) const { return (weighted(weight_d, i) - parts.filter) / tau[i]; }
  double wanted(Index i, const Parts& parts) const {
    const double sum = kp[i] * weighted(weight_p, i) + parts.integral;
    return kd[i] == 0.0 ? sum : sum + kd[i] * slope(i, parts);
  }
  double limited(double number, Index i) const { return std::clamp(number, lower[i], upper[i]); }

  /// Applies a reset. In manual mode, tracks the manual command with the integral part, for a bumpless
  /// transfer.
  STEPWIRE_RARE void take_over() {
    for (Index i = 0; i < integral.size(); ++i) {
      const Parts parts = at_instant(i);
      const double others = wanted(i, parts) - parts.integral;
      integral[i] = by_hand() ? limited(manual[i], i) - others : parts.integral;
      filter[i] = parts.filter;
    }
    hand = by_hand() ? 1.0 : 0.0;
    remember_reset();
  }

  /// Returns the rate of the integral part without its own limits. Clamping stops it between two instants, or
  /// not at all.
  double free_rate(Index i) const {
    double rate = ki[i] * u[i];
    const double want = wanted(i, here(i)), give = limited(want, i);
    if (anti_windup == AntiWindup::clamping && at_limit[i] * rate > 0.0) rate = 0.0;
    if (anti_windup == AntiWindup::back_calculation) rate += (give - want) / tracking[i];
    if (actual.connected()) rate += (actual[i] - give) / tracking[i];
    return rate;
  }
  double integral_rate(Index i) const {
    const double rate = free_rate(i);
    return stop[i] * rate > 0.0 ? 0.0 : rate;
  }
};

}  // namespace stepwire

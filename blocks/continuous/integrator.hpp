#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"
#include "engine/block/limits.hpp"

namespace stepwire {

/// Integral of its input: dx/dt = u, y = x, within limits and with a reset where they are asked for.
struct Integrator {
  enum class Trigger { rising, falling, either, level };

  // What every step needs lies together; most integrators have neither limits nor a reset.
  Input<> u{};
  State<> x{};
  bool limited = false, resets = false;

  PerElement lower = -unlimited, upper = unlimited;
  Trigger trigger = Trigger::rising;
  Input<1> reset{};
  Input<> value{};
  Output<> y{};
  DiscreteState<> home{};   // what a reset goes back to where no value is wired
  DiscreteState<> stop{};   // 1 at the upper and -1 at the lower limit at the last tick, 0 between
  DiscreteState<1> side{};  // of the reset signal at the last tick: -1 false, 1 true, 0 none seen yet

  void outputs() {
    const bool now = resetting();
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = limit(now ? target(i) : x.coeff(i), i);
  }

  void derivatives() {
    if (!limited && !resets) {
      x.dot = u;
      return;
    }
    const bool held = resets && trigger == Trigger::level && reset > 0.0;
    for (Eigen::Index i = 0; i < x.size(); ++i) x.dot.coeffRef(i) = held ? 0.0 : gated(u.coeff(i), i);
  }

  void update() {
    const bool now = resetting();
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      x.coeffRef(i) = limit(now ? target(i) : x.coeff(i), i);
      stop.coeffRef(i) = x.coeff(i) >= upper.coeff(i) ? 1.0 : x.coeff(i) <= lower.coeff(i) ? -1.0 : 0.0;
    }
    if (resets) side = reset > 0.0 ? 1.0 : -1.0;
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<Integrator>& is);

 private:
  bool resetting() const {
    if (!resets) return false;
    const bool high = reset > 0.0;
    if (trigger == Trigger::level) return high;
    const bool rose = side < 0.0 && high, fell = side > 0.0 && !high;
    return (rose && trigger != Trigger::falling) || (fell && trigger != Trigger::rising);
  }
  double target(Eigen::Index i) const { return value.connected() ? value.coeff(i) : home.coeff(i); }
  double limit(double number, Eigen::Index i) const {
    return std::clamp(number, lower.coeff(i), upper.coeff(i));
  }
  /// A limit holds for whole steps: found in the middle of one, it would spoil the solver's order.
  double gated(double rate, Eigen::Index i) const { return stop.coeff(i) * rate > 0.0 ? 0.0 : rate; }
};

}  // namespace stepwire

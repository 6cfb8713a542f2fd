#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Integral of its input: dx/dt = u, y = x, within limits and with a reset where they are asked for.
struct Integrator {
  enum class Trigger { rising, falling, either, level };

  // What every step needs lies together; most integrators have neither limits nor a reset.
  Input<> u{};
  State<> x{};
  bool slope_is_input = true, limited = false, resets = false;

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
    for (Index i = 0; i < y.size(); ++i) y[i] = limit(now ? target(i) : x[i], i);
  }

  void derivatives() {
    if (slope_is_input) {
      x.dot = u;
    } else {
      integrate_within_limits();
    }
  }

  void update() {
    const bool now = resetting();
    for (Index i = 0; i < x.size(); ++i) {
      x[i] = limit(now ? target(i) : x[i], i);
      stop[i] = x[i] >= upper[i] ? 1.0 : x[i] <= lower[i] ? -1.0 : 0.0;
    }
    if (resets) side = reset > 0.0 ? 1.0 : -1.0;
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<Integrator>& is);

 private:
  STEPWIRE_RARE void integrate_within_limits() {
    const bool held = resets && trigger == Trigger::level && reset > 0.0;
    for (Index i = 0; i < x.size(); ++i) x.dot[i] = held ? 0.0 : gated(u[i], i);
  }
  bool resetting() const {
    if (!resets) return false;
    const bool high = reset > 0.0;
    if (trigger == Trigger::level) return high;
    const bool rose = side < 0.0 && high, fell = side > 0.0 && !high;
    return (rose && trigger != Trigger::falling) || (fell && trigger != Trigger::rising);
  }
  double target(Index i) const { return value.connected() ? value[i] : home[i]; }
  double limit(double number, Index i) const { return std::clamp(number, lower[i], upper[i]); }
  /// A limit holds for whole steps: found in the middle of one, it would spoil the solver's order.
  double gated(double rate, Index i) const { return stop[i] * rate > 0.0 ? 0.0 : rate; }
};

}  // namespace stepwire

#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Learnt resistance R = fast + slow to a motion of velocity v, from the felt force.
///
/// With the direction u = v / max(|v|, v_s), the share moving = min(1, |v| / v_s), and the felt resistance
/// R_felt = force u,
///
///     fast' = -fast/T_f + moving b_f (R_felt - R),   slow' = -slow/T_s + moving b_s (R_felt - R),
///     F' = (R u - F)/onset,   |F| <= min(strength, most L),
///
/// where L follows R_felt, upward at once and downward in the time `reflex`. The part of R above L is removed
/// from `fast`.
struct LoadAdaptation {
  Input<2> force{}, velocity{};
  double fast_time = 1.14, fast_rate = 0.35, slow_time = 75.0, slow_rate = 0.033;
  double smoothing = 0.01, strength = 20.0, most = 0.9, reflex = 0.05, onset = 0.3;
  Output<2> y{};
  Output<1> learned{}, felt{};
  DiscreteState<2> push{};                  ///< F
  DiscreteState<1> fast{}, slow{}, held{};  ///< `held` is L
  Period period;

  void outputs() {
    felt = moving() > 0.0 ? (force[0] * velocity[0] + force[1] * velocity[1]) / speed() : 0.0;
    learned = fast + slow;
    const double share = -fn::expm1(-period / onset);
    for (Index i = 0; i < 2; ++i) {
      const double meant =
          std::max(0.0, static_cast<double>(learned)) * velocity[i] / std::max(speed(), smoothing);
      y[i] = push[i] + share * (meant - push[i]);
    }
    const double most_now = std::min(strength, most * limit()), far = fn::hypot(y[0], y[1]);
    if (far > most_now)
      for (Index i = 0; i < 2; ++i) y[i] = y[i] * most_now / far;
  }

  void update() {
    push = y;
    held = limit();
    const double wrong = moving() * (felt - learned);
    slow = slow + period * (slow_rate * wrong - slow / slow_time);
    fast = fast + period * (fast_rate * wrong - fast / fast_time);
    const double too_much = std::min(fast + slow - held, static_cast<double>(fast));
    if (too_much > 0.0 && moving() > 0.0) fast = fast - std::min(1.0, period / reflex) * too_much;
  }

  static void declare(Declare<LoadAdaptation>& is);

 private:
  double speed() const { return fn::hypot(velocity[0], velocity[1]); }
  double moving() const { return std::min(1.0, speed() / smoothing); }
  double limit() const {
    const double now = std::max(0.0, static_cast<double>(felt));
    return now >= held ? now : now + (held - now) * fn::exp(-period / reflex);
  }
};

}  // namespace stepwire

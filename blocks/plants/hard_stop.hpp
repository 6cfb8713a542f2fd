#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Two rigid stops for a mass. It rebounds with `restitution` of its speed. If that is below `slow`, it rests
/// against the stop until the other forces pull it away.
struct HardStop {
  PerElement mass = 1.0, lower = -unlimited, upper = unlimited, restitution = 0.0, slow = 1e-3;
  Input<> force{}, position{}, velocity{};
  Output<> y{}, hit{}, rebound{}, rests{};
  DiscreteState<> side{};  // 1 and -1 while it rests at the upper and the lower stop, as of the last instant.
  DiscreteState<> rest{};  // Velocity of a resting mass at the last instant.
  DiscreteState<> struck{};     // 1 after a hit at the last instant, else -1; 0 before the first one.
  DiscreteState<> struck_at{};  // Time of the last hit at a tick [s].
  Diagnostic begins_beyond{};

  Time t{};
  Period period{};

  void outputs() {
    for (Index i = 0; i < y.size(); ++i) {
      show(i, side[i], rest[i]);
      hit[i] = 0.0;
      rebound[i] = velocity[i];
    }
  }
  void outputs_at_instant() {
    for (Index i = 0; i < y.size(); ++i) {
      const bool now = is_hit(i);
      show(i, next_side(i), now ? 0.0 : velocity[i]);
      hit[i] = now ? 1.0 : 0.0;
      rebound[i] = !now ? velocity[i] : is_slow(i) ? 0.0 : -restitution[i] * velocity[i];
    }
  }
  void update() {
    for (Index i = 0; i < side.size(); ++i) {
      if (struck[i] == 0.0 && is_beyond(i)) begins_beyond.raise(t);
      if (is_hit(i)) struck_at[i] = t;
      follow(i);
    }
  }
  /// A hit at a tick counts until the next instant, also while the tick is settled.
  void update_at_event() {
    for (Index i = 0; i < side.size(); ++i)
      if (!(struck[i] > 0.0 && struck_at[i] == t)) follow(i);
  }
  void crossings(Crossings& zero) const {
    for (Index i = 0; i < side.size(); ++i)
      zero.add(side[i] != 0.0 ? side[i] * force[i] : upper[i] - position[i]);
    for (Index i = 0; i < side.size(); ++i) zero.add(side[i] != 0.0 ? 1.0 : position[i] - lower[i]);
  }

  void start() {
    for (Index i = 0; i < side.size(); ++i) struck_at[i] = -1.0;
  }
  void configure(Configure& is);
  static void declare(Declare<HardStop>& is);

 private:
  /// True beyond a stop by more than rounding and a step at the speed `slow`. At the first instant no impact
  /// has brought the body there.
  bool is_beyond(Index i) const {
    const double margin = 1e-9 * std::abs(position[i]) + slow[i] * period;
    return position[i] > upper[i] + margin || position[i] < lower[i] - margin;
  }
  void follow(Index i) {
    const bool now = is_hit(i);
    side[i] = next_side(i);
    rest[i] = now ? 0.0 : velocity[i];
    struck[i] = now ? 1.0 : -1.0;
  }
  /// Returns the stop that it is at and moves into, or is pressed into while it does not move: 1 the upper,
  /// -1 the lower, 0 none.
  double meets(Index i) const {
    if (side[i] != 0.0) return 0.0;
    const double into = velocity[i] != 0.0 ? velocity[i] : force[i];
    if (position[i] >= upper[i] && into > 0.0) return 1.0;
    return position[i] <= lower[i] && into < 0.0 ? -1.0 : 0.0;
  }
  /// True for a new hit. Resets react to the edge of `hit`, so there is none at the first instant and none
  /// directly after another. A mass that does not leave the stop by its rebound rests there.
  bool is_hit(Index i) const { return meets(i) != 0.0 && velocity[i] != 0.0 && struck[i] < 0.0; }
  bool is_slow(Index i) const { return restitution[i] * std::abs(velocity[i]) <= slow[i]; }

  double next_side(Index i) const {
    if (side[i] != 0.0) return side[i] * force[i] < 0.0 ? 0.0 : side[i];
    return is_slow(i) || struck[i] > 0.0 ? meets(i) : 0.0;
  }

  /// Removes the remaining velocity from a resting mass within a step.
  void show(Index i, double now, double left) {
    rests[i] = now;
    y[i] = now == 0.0 ? 0.0 : -force[i] - mass[i] * left / period;
  }
};

}  // namespace stepwire

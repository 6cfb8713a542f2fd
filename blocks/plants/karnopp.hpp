#pragma once

#include "blocks/plants/dry_friction.hpp"

namespace stepwire {

/// Karnopp's model of dry friction: a body slower than `band` counts as at rest. There the friction balances
/// the other forces up to `breakaway`. Above the band it is that of Friction.
struct Karnopp : DryFriction {
  PerElement band = 1e-3;
  Output<> pseudo{};

  void outputs() {
    for (Index i = 0; i < y.size(); ++i) show(i, way[i], rest[i]);
  }
  void outputs_at_instant() {
    for (Index i = 0; i < y.size(); ++i) show(i, next_way(i), next_rest(i));
  }
  void update() {
    for (Index i = 0; i < way.size(); ++i) {
      const double left = next_rest(i);
      way[i] = next_way(i);
      rest[i] = left;
    }
  }
  void crossings(Crossings& zero) const {
    for (Index i = 0; i < way.size(); ++i)
      zero.add(way[i] != 0.0 ? way[i] * velocity[i] - band[i] : band[i] - std::abs(velocity[i]));
    for (Index i = 0; i < way.size(); ++i) zero.add(way[i] != 0.0 ? 1.0 : highest(i) - std::abs(force[i]));
  }

  static void declare(Declare<Karnopp>& is);

 private:
  bool is_held(Index i) const { return std::abs(force[i]) <= highest(i); }

  /// Returns the next mode. A step may carry a body through the whole band.
  double next_way(Index i) const {
    const double v = velocity[i];
    if (std::abs(v) <= band[i]) return 0.0;
    if (way[i] * v < 0.0 && is_held(i) && !is_thrown_back(i)) return 0.0;
    return v > 0.0 ? 1.0 : -1.0;
  }
  /// Returns the velocity to be removed from the body; 0 for a body that breaks away.
  double next_rest(Index i) const { return next_way(i) == 0.0 && is_held(i) ? velocity[i] : 0.0; }

  void show(Index i, double now, double left) {
    slides[i] = now;
    pseudo[i] = now == 0.0 ? 0.0 : velocity[i];
    y[i] = now == 0.0 ? -std::clamp(force[i], -highest(i), highest(i)) + braking(i, left)
                      : sliding_force(i, now);
  }
};

}  // namespace stepwire

#pragma once

#include "blocks/plants/dry_friction.hpp"

namespace stepwire {

/// Dry friction on a mass, with sticking. At rest it balances the other forces up to `breakaway`. In motion
/// it is coulomb + (breakaway - coulomb) exp(-(v/stribeck)^2) + viscous |v| against the motion.
struct Friction : DryFriction {
  void outputs() {
    for (Index i = 0; i < y.size(); ++i) show(i, way[i], rest[i]);
  }
  void outputs_at_instant() {
    for (Index i = 0; i < y.size(); ++i) show(i, next_way(i), velocity[i]);
  }
  void update() {
    for (Index i = 0; i < way.size(); ++i) {
      way[i] = next_way(i);
      rest[i] = velocity[i];
    }
  }
  void crossings(Crossings& zero) const {
    for (Index i = 0; i < way.size(); ++i) zero.add(way[i] != 0.0 ? way[i] * velocity[i] : 1.0);
    for (Index i = 0; i < way.size(); ++i) zero.add(way[i] != 0.0 ? 1.0 : highest(i) - std::abs(force[i]));
  }

  static void declare(Declare<Friction>& is);

 private:
  /// True if the velocity was not caused by a force: after a reset, or at a start in motion.
  bool is_moved(Index i) const {
    if (way[i] != 0.0) return is_thrown_back(i);
    return std::abs(velocity[i]) > 2.0 * std::abs(rest[i]) + 1e-9 * highest(i) * period / mass[i];
  }

  double next_way(Index i) const {
    const double push = force[i];
    if (way[i] * velocity[i] > 0.0) return way[i];
    if (is_moved(i)) return velocity[i] > 0.0 ? 1.0 : -1.0;
    if (std::abs(push) <= highest(i)) return 0.0;
    return push > 0.0 ? 1.0 : -1.0;
  }

  void show(Index i, double now, double left) {
    slides[i] = now;
    y[i] = now == 0.0 ? -force[i] + braking(i, left) : sliding_force(i, now);
  }
};

}  // namespace stepwire

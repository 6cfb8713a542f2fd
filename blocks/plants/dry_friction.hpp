#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Dry friction on a mass that sticks or slides: parameters, ports and modes of Friction and Karnopp, which
/// differ in the condition for sticking.
struct DryFriction {
  PerElement mass = 1.0, coulomb = 1.0, breakaway = 0.0, viscous = 0.0, stribeck = 0.0;
  Input<> force{}, velocity{};
  Output<> y{}, slides{};
  DiscreteState<> way{};   // sign of the sliding, 0 while sticking, as of the last instant
  DiscreteState<> rest{};  // velocity at the last instant, which a sticking mass still has

  Period period{};

 protected:
  /// Returns the largest friction [N] of a body at rest.
  double highest(Index i) const { return std::max(breakaway[i], coulomb[i]); }
  /// Returns the dry friction [N] of a body in motion.
  double sliding(Index i) const {
    const double v = velocity[i], more = highest(i) - coulomb[i];
    const double part = stribeck[i] > 0.0 ? fn::exp(-(v / stribeck[i]) * (v / stribeck[i])) : 0.0;
    return coulomb[i] + more * part;
  }
  double sliding_force(Index i, double now) const { return -now * sliding(i) - viscous[i] * velocity[i]; }

  /// True for a velocity against `way` that no force of one step explains: a reset has reversed the body.
  bool is_thrown_back(Index i) const {
    const double most = highest(i) + std::abs(force[i]) + viscous[i] * std::abs(rest[i]);
    return std::abs(velocity[i]) > 2.0 * most * period / mass[i];
  }
  /// Returns the force [N] that removes the velocity `left` from the mass within a step.
  double braking(Index i, double left) const { return -mass[i] * left / period; }
};

}  // namespace stepwire

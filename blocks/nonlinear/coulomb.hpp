#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Coulomb and viscous friction: y = coulomb sign(u) + viscous u, with an optionally smoothed sign.
struct Coulomb {
  PerElement coulomb = 1.0, viscous = 0.0, smoothing = 0.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> side{};  // sign of the speed at the last instant

  bool holds_side = false;  // Between instants an unsmoothed sign is that side.

  void outputs() {
    y.each([&](Index i) { return coulomb[i] * direction(i) + viscous[i] * u[i]; });
  }
  void outputs_at_instant() {
    for (Index i = 0; i < side.size(); ++i) side[i] = sign(u[i]);
    outputs();
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) zero.add(smoothing[i] > 0.0 ? 1.0 : u[i]);
  }

  void configure(Configure& is);
  static void declare(Declare<Coulomb>& is);

 private:
  double direction(Index i) const {
    if (smoothing[i] > 0.0) return fn::tanh(u[i] / smoothing[i]);
    return holds_side ? side[i] : sign(u[i]);
  }
  static double sign(double v) { return v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : v; }  // preserves 0 and NaN
};

}  // namespace stepwire

#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Predicted motion of a hand: that of a mass that a spring and a dashpot lead,
///
///     e' = (equilibrium - e)/muscle,   mass x'' = damping (e' - x') + stiffness (e - x),
///
/// in semi-implicit steps of a quarter of the period. The learnt load and the force that compensates it
/// cancel.
struct ForwardModel {
  Input<2> equilibrium{};
  Input<1> stiffness{}, damping{};
  double mass = 1.0, muscle = 0.1;
  Output<2> position{}, velocity{};
  DiscreteState<2> x{}, v{}, e{};
  Period period;

  void outputs() {
    position = x;
    velocity = v;
  }

  void update() {
    constexpr int parts = 4;
    const double h = period / parts, decay = fn::exp(-h / muscle);
    for (int part = 0; part < parts; ++part)
      for (Index i = 0; i < 2; ++i) {
        const double before = e[i];
        e[i] = equilibrium[i] + (before - equilibrium[i]) * decay;
        const double pull = damping * (e[i] - before) / h + stiffness * (e[i] - x[i]);
        v[i] = (v[i] + h * pull / mass) / (1.0 + h * damping / mass);
        x[i] = x[i] + h * v[i];
      }
  }

  static void declare(Declare<ForwardModel>& is);
};

}  // namespace stepwire

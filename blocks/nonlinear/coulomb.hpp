#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Coulomb and viscous friction: y = coulomb sign(u) + viscous u, with an optionally smoothed sign.
struct Coulomb {
  PerElement coulomb = 1.0, viscous = 0.0, smoothing = 0.0;
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return coulomb[i] * direction(i) + viscous[i] * u[i]; });
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) zero.add(smoothing[i] > 0.0 ? 1.0 : u[i]);
  }

  static void declare(Declare<Coulomb>& is);

 private:
  double direction(Index i) const {
    const double v = u[i], width = smoothing[i];
    if (width > 0.0) return std::tanh(v / width);
    return v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : v;  // preserves 0 and NaN
  }
};

}  // namespace stepwire

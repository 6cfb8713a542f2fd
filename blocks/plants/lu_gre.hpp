#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// LuGre friction model: bristles of the mean deflection z, with dz/dt = v - stiffness |v| z / g(v) and g(v)
/// = coulomb + (breakaway - coulomb) exp(-(v/stribeck)^2). The force against the motion is stiffness z +
/// damping dz/dt + viscous v.
struct LuGre {
  PerElement stiffness = 1e5, damping = 316.0, viscous = 0.4, coulomb = 1.0, breakaway = 1.5, stribeck = 1e-3;
  Input<> velocity{};
  Output<> y{};
  State<> z{};

  void outputs() {
    y.each([&](Index i) { return -(stiffness[i] * z[i] + damping[i] * rate(i) + viscous[i] * velocity[i]); });
  }
  void derivatives() {
    z.derivative.each([&](Index i) { return rate(i); });
  }

  static void declare(Declare<LuGre>& is);

 private:
  double rate(Index i) const {
    const double v = velocity[i], part = v / stribeck[i];
    const double level =
        coulomb[i] + (std::max(breakaway[i], coulomb[i]) - coulomb[i]) * fn::exp(-part * part);
    return v - stiffness[i] * std::abs(v) / level * z[i];
  }
};

}  // namespace stepwire

#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Dahl's friction model: a force F against the motion with dF/dx = stiffness (1 - sign(v) F /
/// coulomb)^shape.
struct Dahl {
  PerElement stiffness = 1e5, coulomb = 1.0, shape = 1.0;
  Input<> velocity{};
  Output<> y{};
  State<> force{};

  void outputs() {
    y.each([&](Index i) { return -force[i]; });
  }
  void derivatives() {
    force.derivative.each([&](Index i) {
      const double v = velocity[i], side = v > 0.0 ? 1.0 : -1.0;
      const double left = 1.0 - side * force[i] / coulomb[i];
      return stiffness[i] * v * (shape[i] == 1.0 ? left : fn::pow(std::max(left, 0.0), shape[i]));
    });
  }

  static void declare(Declare<Dahl>& is);
};

}  // namespace stepwire

#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// A point mass: m dv/dt = F, dx/dt = v. With a vector of forces, one motion per element.
struct Mass {
  PerElement mass = 1.0;
  Input<> force{};
  Output<> position{}, velocity{};
  State<> position_{}, velocity_{};

  void derivatives() {
    position_.derivative = velocity_;
    velocity_.derivative.each([&](Index i) { return force[i] / mass[i]; });
  }

  static void declare(Declare<Mass>& is);
};

}  // namespace stepwire

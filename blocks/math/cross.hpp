#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Cross product of two vectors in space: y = u1 x u2.
struct Cross {
  Inputs u{};
  Output<3> y{};

  void outputs() {
    const Inputs::Element &a = u[0], &b = u[1];
    y[0] = a[1] * b[2] - a[2] * b[1];
    y[1] = a[2] * b[0] - a[0] * b[2];
    y[2] = a[0] * b[1] - a[1] * b[0];
  }

  void configure(Configure& is);
  static void declare(Declare<Cross>& is);
};

}  // namespace stepwire

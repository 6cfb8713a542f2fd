#pragma once

#include "blocks/math/rotation.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Product of two quaternions: the rotation `right`, followed by the rotation `left`.
struct QuaternionProduct {
  bool inverse = false;
  Input<4> left{}, right{};
  Output<4> y{};

  void outputs() {
    const double sign = inverse ? -1.0 : 1.0;
    const double first[4] = {left[0], sign * left[1], sign * left[2], sign * left[3]};
    rotation::multiply(first, right, y);
  }

  static void declare(Declare<QuaternionProduct>& is);
};

}  // namespace stepwire

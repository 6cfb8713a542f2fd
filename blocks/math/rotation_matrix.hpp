#pragma once

#include "blocks/math/rotation.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Matrix of a rotation in space.
struct RotationMatrix {
  rotation::Order order = rotation::Order::zyx;
  Input<3> angles{}, axis{};
  Input<1> angle{};
  Input<4> quaternion{};
  Output<> y{};

  void outputs() {
    if (angles.connected()) return rotation::matrix_of_angles(order, angles, y);
    if (quaternion.connected()) return rotation::matrix_of(quaternion, y);
    double q[4];
    rotation::quaternion_of_axis(axis, angle, q);
    rotation::matrix_of(q, y);
  }

  void configure(Configure& is);
  static void declare(Declare<RotationMatrix>& is);
};

}  // namespace stepwire

#pragma once

#include "blocks/math/rotation.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Rotation of a vector in space: y = R u, or y = R' u with `inverse`.
struct Rotate3D {
  rotation::Order order = rotation::Order::zyx;
  bool inverse = false;
  Input<3> u{}, angles{}, axis{};
  Input<1> angle{};
  Input<4> quaternion{};
  Output<3> y{};

  void outputs() {
    double m[9];
    find_matrix(m);
    for (Index row = 0; row < 3; ++row) {
      double sum = 0.0;
      for (Index k = 0; k < 3; ++k) sum += (inverse ? m[3 * row + k] : m[3 * k + row]) * u[k];
      y[row] = sum;
    }
  }

  void configure(Configure& is);
  static void declare(Declare<Rotate3D>& is);

 private:
  void find_matrix(double* m) const {
    if (angles.connected()) return rotation::matrix_of_angles(order, angles, m);
    if (quaternion.connected()) return rotation::matrix_of(quaternion, m);
    double q[4];
    rotation::quaternion_of_axis(axis, angle, q);
    rotation::matrix_of(q, m);
  }
};

}  // namespace stepwire

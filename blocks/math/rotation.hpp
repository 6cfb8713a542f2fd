#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/base/math/sum_of_squares.hpp"
#include "engine/model/signal/index.hpp"

namespace stepwire {

/// Rotations in space: matrices are stored column by column, quaternions as [w, x, y, z].
namespace rotation {

/// Sequences of axes of three successive rotations, each about the rotated axes.
enum class Order { xyz, xzy, yxz, yzx, zxy, zyx, xyx, xzx, yxy, yzy, zxz, zyz };

/// Writes the axes of a sequence: 0, 1, 2 for x, y, z.
inline void axes_of(Order order, Index* axes) {
  constexpr Index all[12][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0},
                                {0, 1, 0}, {0, 2, 0}, {1, 0, 1}, {1, 2, 1}, {2, 0, 2}, {2, 1, 2}};
  for (Index k = 0; k < 3; ++k) axes[k] = all[static_cast<int>(order)][k];
}

/// Computes q = a b.
template <class A, class B, class Product>
void multiply(const A& a, const B& b, Product&& q) {
  q[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  q[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  q[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  q[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

/// Computes the matrix of a quaternion of any length but 0, for which the result is NaN.
template <class Q, class M>
void matrix_of(const Q& of, M&& m) {
  SumOfSquares squares;
  for (Index k = 0; k < 4; ++k) squares.add(of[k]);
  const double scale = squares.scale(), q[4] = {of[0] * scale, of[1] * scale, of[2] * scale, of[3] * scale};
  const double s = 2.0 / squares.scaled();
  m[0] = 1.0 - s * (q[2] * q[2] + q[3] * q[3]);
  m[1] = s * (q[1] * q[2] + q[0] * q[3]);
  m[2] = s * (q[1] * q[3] - q[0] * q[2]);
  m[3] = s * (q[1] * q[2] - q[0] * q[3]);
  m[4] = 1.0 - s * (q[1] * q[1] + q[3] * q[3]);
  m[5] = s * (q[2] * q[3] + q[0] * q[1]);
  m[6] = s * (q[1] * q[3] + q[0] * q[2]);
  m[7] = s * (q[2] * q[3] - q[0] * q[1]);
  m[8] = 1.0 - s * (q[1] * q[1] + q[2] * q[2]);
}

/// Computes the matrix of three successive rotations.
template <class Angles, class M>
void matrix_of_angles(Order order, const Angles& angles, M&& m) {
  Index axes[3];
  axes_of(order, axes);
  for (Index k = 0; k < 9; ++k) m[k] = k % 4 == 0 ? 1.0 : 0.0;
  for (Index turn = 0; turn < 3; ++turn) {
    const double c = fn::cos(angles[turn]), s = fn::sin(angles[turn]);
    const Index one = 3 * ((axes[turn] + 1) % 3), two = 3 * ((axes[turn] + 2) % 3);
    for (Index row = 0; row < 3; ++row) {
      const double first = m[one + row], second = m[two + row];
      m[one + row] = c * first + s * second;
      m[two + row] = c * second - s * first;
    }
  }
}

/// Computes the quaternion of a rotation by an angle about an axis of any length but 0.
template <class Axis>
void quaternion_of_axis(const Axis& axis, double angle, double* q) {
  const double length = length_of(3, [&](Index k) { return axis[k]; });
  q[0] = fn::cos(0.5 * angle);
  for (Index k = 0; k < 3; ++k) q[k + 1] = fn::sin(0.5 * angle) * axis[k] / length;
}

}  // namespace rotation

}  // namespace stepwire

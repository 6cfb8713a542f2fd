#include "blocks/math/rotation_matrix.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void RotationMatrix::declare(Declare<RotationMatrix>& is) {
  is.block(
      "RotationMatrix",
      {.doc = "The 3 x 3 matrix R of a turn, by one of three, as Rotate3D has them: `angles` in an `order` "
              "(zyx: R = Rz(a1) Ry(a2) Rx(a3)), `axis` and `angle`, or `quaternion` [w, x, y, z].",
       .source = "e.g. Diebel, Representing Attitude, Stanford University, 2006",
       .symbol = {.text = "R"},
       .smooth = true});
  is.parameter<&RotationMatrix::order>(
      {.doc = "axes of the angles, one after the other",
       .words = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"}});
  is.input<&RotationMatrix::angles>(
      {.unit = "rad", .doc = "three angles, in the order of `order`", .optional = true});
  is.input<&RotationMatrix::axis>({.unit = "*", .doc = "axis of the turn", .optional = true});
  is.input<&RotationMatrix::angle>(
      {.unit = "rad", .doc = "angle about the axis, by the right hand", .optional = true});
  is.input<&RotationMatrix::quaternion>({.doc = "the turn as [w, x, y, z]", .optional = true});
  is.output<&RotationMatrix::y>({.shape = "3 x 3", .doc = "the matrix"});
}

void RotationMatrix::configure(Configure& is) {
  if (is.connected<&RotationMatrix::axis>()) is.require<&RotationMatrix::angle>("an axis is wired");
  if (!is.connected<&RotationMatrix::angles>() && !is.connected<&RotationMatrix::axis>() &&
      !is.connected<&RotationMatrix::quaternion>())
    is.require<&RotationMatrix::angles>(
        "or axis and angle, or a quaternion: something must say how it is turned");
}

}  // namespace stepwire

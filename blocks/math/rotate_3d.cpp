#include "blocks/math/rotate_3d.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Rotate3D::declare(Declare<Rotate3D>& is) {
  is.block(
      "Rotate3D",
      {.doc =
           "A vector of space turned, y = R u, by one of three: `angles`, three of them, each about an axis "
           "that the ones before have turned (order zyx: R = Rz(a1) Ry(a2) Rx(a3), yaw, pitch and roll); "
           "`axis` and `angle`; or `quaternion` [w, x, y, z]. What has coordinates in the turned frame has y "
           "in the fixed one; with `inverse` it is the other way. Axis and quaternion may have any length "
           "but 0.",
       .source = "e.g. Diebel, Representing Attitude, Stanford University, 2006",
       .symbol = {.text = "R u"},
       .smooth = true});
  is.parameter<&Rotate3D::order>(
      {.doc = "axes of the angles, one after the other",
       .words = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"}});
  is.parameter<&Rotate3D::inverse>({.doc = "turn the other way"});
  is.input<&Rotate3D::u>({.unit = "'u", .doc = "vector"});
  is.input<&Rotate3D::angles>(
      {.unit = "rad", .doc = "three angles, in the order of `order`", .optional = true});
  is.input<&Rotate3D::axis>({.unit = "*", .doc = "axis of the turn", .optional = true});
  is.input<&Rotate3D::angle>(
      {.unit = "rad", .doc = "angle about the axis, by the right hand", .optional = true});
  is.input<&Rotate3D::quaternion>({.doc = "the turn as [w, x, y, z]", .optional = true});
  is.output<&Rotate3D::y>({.unit = "'u", .doc = "the turned vector"});
}

void Rotate3D::configure(Configure& is) {
  const bool by_angles = is.connected<&Rotate3D::angles>(), by_axis = is.connected<&Rotate3D::axis>(),
             by_quaternion = is.connected<&Rotate3D::quaternion>();
  if (by_axis) is.require<&Rotate3D::angle>("an axis is wired");
  if (!by_angles && !by_axis && !by_quaternion)
    is.require<&Rotate3D::angles>("or axis and angle, or a quaternion: something must say how u is turned");
}

}  // namespace stepwire

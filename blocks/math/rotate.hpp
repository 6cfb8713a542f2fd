#pragma once

#include <cmath>

#include "engine/base/math/elementary.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Rotation of a vector in the plane, or with `inverse` the reversed one. With c and s the cosine and sine of
/// the angle, y = [c u1 - s u2, s u1 + c u2].
struct Rotate {
  bool inverse = false;
  Input<2> u{};
  Input<1> angle{};
  Output<2> y{};

  void outputs() {
    const double c = fn::cos(angle), s = inverse ? -fn::sin(angle) : fn::sin(angle);
    y[0] = c * u[0] - s * u[1];
    y[1] = s * u[0] + c * u[1];
  }

  static void declare(Declare<Rotate>& is);
};

}  // namespace stepwire

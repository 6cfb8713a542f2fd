#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// A vector of the plane turned by an angle: y = [c u1 - s u2, s u1 + c u2] with c, s = cos, sin of the
/// angle; the other way with `inverse`.
struct Rotate {
  bool inverse = false;
  Input<2> u{};
  Input<1> angle{};
  Output<2> y{};

  void outputs() {
    const double c = std::cos(angle), s = inverse ? -std::sin(angle) : std::sin(angle);
    y[0] = c * u[0] - s * u[1];
    y[1] = s * u[0] + c * u[1];
  }

  static void declare(Declare<Rotate>& is);
};

}  // namespace stepwire

#pragma once

#include <algorithm>

#include "engine/block/block.hpp"

namespace stepwire {

/// Magnitude of the largest resistance over the signed distance Er from the resistance boundary, positive
/// outside.
struct Proportionality {
  enum class Law { P1, P2 };

  Law law = Law::P1;
  double offset = 0.0, slope = 0.0;
  double W = -1e-3, maximum = 0.0;
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return magnitude(u[i]); });
  }

  double magnitude(double error) const {
    if (law == Law::P1) return error >= 0.0 ? offset + slope * error : 0.0;
    return maximum * std::clamp(1.0 - error / W, 0.0, 1.0);
  }

  void configure(Configure& is);

  static void declare(Declare<Proportionality>& is);
};

}  // namespace stepwire

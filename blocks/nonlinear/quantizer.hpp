#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Nearest multiple of an interval: y = interval floor(u / interval + 1/2).
struct Quantizer {
  PerElement interval = 1.0;
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return interval[i] * std::floor(u[i] / interval[i] + 0.5); });
  }

  /// Adds the distance to the next step of the staircase, negative on every second tread.
  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) {
      const double x = u[i] / interval[i] + 0.5, tread = std::floor(x), share = x - tread;
      const double distance = std::fmin(share, 1.0 - share);
      zero.add(std::fmod(tread, 2.0) == 0.0 ? distance : -distance);
    }
  }

  static void declare(Declare<Quantizer>& is);
};

}  // namespace stepwire

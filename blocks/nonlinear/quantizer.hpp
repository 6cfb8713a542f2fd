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

  static void declare(Declare<Quantizer>& is);
};

}  // namespace stepwire

#pragma once

#include <algorithm>

#include "engine/block/block.hpp"

namespace stepwire {

/// The input within limits: y = min(max(u, lower), upper).
struct Saturation {
  PerElement lower = -unlimited, upper = unlimited;
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Index i = 0; i < y.size(); ++i) y[i] = std::clamp(u[i], lower[i], upper[i]);
  }

  void configure(Configure& is);
  static void declare(Declare<Saturation>& is);
};

}  // namespace stepwire

#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The input within limits: y = min(max(u, lower), upper).
struct Saturation {
  PerElement lower = -unlimited, upper = unlimited;
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return std::clamp(u[i], lower[i], upper[i]); });
  }

  void configure(Configure& is);
  static void declare(Declare<Saturation>& is);
};

}  // namespace stepwire

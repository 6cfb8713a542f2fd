#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Zero within a zone, and how far the input lies outside of it elsewhere.
struct DeadZone {
  PerElement lower = -0.5, upper = 0.5;
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return u[i] - std::clamp(u[i], lower[i], upper[i]); });
  }

  void configure(Configure& is);
  static void declare(Declare<DeadZone>& is);
};

}  // namespace stepwire

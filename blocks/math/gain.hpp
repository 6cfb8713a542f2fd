#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Gain of each element: y = gain u.
struct Gain {
  PerElement gain = 1.0;
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return gain[i] * u[i]; });
  }

  static void declare(Declare<Gain>& is);
};

}  // namespace stepwire

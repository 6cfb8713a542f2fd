#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The sign of each element: y = 1, 0 or -1.
struct Sign {
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return static_cast<double>((u[k] > 0.0) - (u[k] < 0.0)); });
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) zero.add(u[i]);
  }

  static void declare(Declare<Sign>& is);
};

}  // namespace stepwire

#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Absolute value of each element: y = |u|.
struct Abs {
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index i) { return std::abs(u[i]); });
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) zero.add(u[i]);
  }

  static void declare(Declare<Abs>& is);
};

}  // namespace stepwire

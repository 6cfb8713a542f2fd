#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The square root of each element: y = sqrt(u), or sign(u) sqrt(|u|).
struct Sqrt {
  bool signed_ = false;
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Index k = 0; k < y.size(); ++k) {
      const double x = u[k];
      y[k] = signed_ ? std::copysign(std::sqrt(std::abs(x)), x) : std::sqrt(x);
    }
  }

  static void declare(Declare<Sqrt>& is);
};

}  // namespace stepwire

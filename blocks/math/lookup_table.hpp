#pragma once

#include "blocks/math/extrapolation.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Piecewise linear curve through points, for each element: y = f(u).
struct LookupTable {
  Numbers points{0.0, 1.0}, values{0.0, 1.0};
  Extrapolation extrapolation = Extrapolation::hold;
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Index k = 0; k < y.size(); ++k) {
      const Bracket at = bracket(points, u[k], extrapolation);
      y[k] = between(values[at.index], values[at.index + 1], at.share);
    }
  }

  void configure(Configure& is);
  static void declare(Declare<LookupTable>& is);
};

}  // namespace stepwire

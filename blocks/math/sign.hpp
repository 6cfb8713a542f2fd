#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// The sign of each element: y = 1, 0 or -1.
struct Sign {
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index k = 0; k < y.size(); ++k)
      y.coeffRef(k) = static_cast<double>((u.coeff(k) > 0.0) - (u.coeff(k) < 0.0));
  }

  static void declare(Declare<Sign>& is);
};

}  // namespace stepwire

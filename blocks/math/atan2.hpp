#pragma once

#include <cmath>

#include "engine/block/declare.hpp"

namespace stepwire {

/// The angle of a direction: y = atan2(opposite, adjacent) in (-pi, pi].
struct Atan2 {
  Input<> opposite{}, adjacent{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index k = 0; k < y.size(); ++k)
      y.coeffRef(k) = std::atan2(opposite.coeff(k), adjacent.coeff(k));
  }

  static void declare(Declare<Atan2>& is);
};

}  // namespace stepwire

#pragma once

#include "blocks/math/extrapolation.hpp"
#include "engine/block/declare.hpp"

namespace stepwire {

/// A curve given by points, straight between them, of each element: y = f(u).
struct LookupTable {
  Eigen::VectorXd points = Eigen::Vector2d(0.0, 1.0), values = Eigen::Vector2d(0.0, 1.0);
  Extrapolation extrapolation = Extrapolation::hold;
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index k = 0; k < y.size(); ++k) {
      const Bracket at = bracket(points, u.coeff(k), extrapolation);
      y.coeffRef(k) = between(values.coeff(at.index), values.coeff(at.index + 1), at.share);
    }
  }

  void configure(Configure& is);
  static void declare(Declare<LookupTable>& is);
};

}  // namespace stepwire

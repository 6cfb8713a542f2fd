#pragma once

#include <cmath>

#include "engine/block/declare.hpp"

namespace stepwire {

/// Coulomb and viscous friction: y = coulomb sign(u) + viscous u, the sign smoothed where asked for.
struct Coulomb {
  PerElement coulomb = 1.0, viscous = 0.0, smoothing = 0.0;
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i)
      y.coeffRef(i) = coulomb.coeff(i) * direction(i) + viscous.coeff(i) * u.coeff(i);
  }

  static void declare(Declare<Coulomb>& is);

 private:
  double direction(Eigen::Index i) const {
    const double v = u.coeff(i), width = smoothing.coeff(i);
    if (width > 0.0) return std::tanh(v / width);
    return v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : v;  // 0 stays 0, and what is no number stays none
  }
};

}  // namespace stepwire

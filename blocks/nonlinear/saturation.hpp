#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"
#include "engine/block/limits.hpp"

namespace stepwire {

/// The input within limits: y = min(max(u, lower), upper).
struct Saturation {
  PerElement lower = -unlimited, upper = unlimited;
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i)
      y.coeffRef(i) = std::clamp(u.coeff(i), lower.coeff(i), upper.coeff(i));
  }

  void configure(Configure& is) { require_order<&Saturation::lower, &Saturation::upper>(*this, is); }
  static void declare(Declare<Saturation>& is);
};

}  // namespace stepwire

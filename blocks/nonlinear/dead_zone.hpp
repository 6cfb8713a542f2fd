#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"
#include "engine/block/limits.hpp"

namespace stepwire {

/// Zero within a zone, and how far the input lies outside of it elsewhere.
struct DeadZone {
  PerElement lower = -0.5, upper = 0.5;
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i)
      y.coeffRef(i) = u.coeff(i) - std::clamp(u.coeff(i), lower.coeff(i), upper.coeff(i));
  }

  void configure(Configure& is) { require_order<&DeadZone::lower, &DeadZone::upper>(*this, is); }
  static void declare(Declare<DeadZone>& is);
};

}  // namespace stepwire

#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"

namespace stepwire {

/// The scalar product of two vectors: y = sum_k u1_k u2_k.
struct Dot {
  Inputs u{};
  Output<1> y{};

  void outputs() {
    const Eigen::Index size = std::max(u.view(0).size(), u.view(1).size());
    double sum = 0.0;
    for (Eigen::Index k = 0; k < size; ++k) sum += u[0][k] * u[1][k];
    y = sum;
  }

  void configure(Configure& is);
  static void declare(Declare<Dot>& is);
};

}  // namespace stepwire

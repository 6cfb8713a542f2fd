#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The scalar product of two vectors: y = sum_k u1_k u2_k.
struct Dot {
  Inputs u{};
  Output<1> y{};

  void outputs() {
    const Index size = std::max(u[0].size, u[1].size);
    double sum = 0.0;
    for (Index k = 0; k < size; ++k) sum += u[0][k] * u[1][k];
    y = sum;
  }

  void configure(Configure& is);
  static void declare(Declare<Dot>& is);
};

}  // namespace stepwire

#pragma once

#include <vector>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Selected elements of a vector: y_k = u[indices_k], counted from 1.
struct Select {
  Numbers indices{1.0};
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Index k = 0; k < indices.size(); ++k) y[k] = u[static_cast<Index>(indices[k]) - 1];
  }

  void configure(Configure& is);
  static void declare(Declare<Select>& is);
};

}  // namespace stepwire

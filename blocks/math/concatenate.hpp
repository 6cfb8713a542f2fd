#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Horizontal concatenation of matrices: y = [u1, u2, ...].
struct Concatenate {
  Inputs u{};
  Output<> y{};

  void outputs() {
    Index next = 0;
    for (Index i = 0; i < u.count(); ++i)
      for (Index k = 0; k < u[i].size; ++k) y[next++] = u[i][k];
  }

  static void declare(Declare<Concatenate>& is);
};

}  // namespace stepwire

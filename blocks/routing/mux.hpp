#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Concatenation of numbers and vectors: y = [u1, u2, ...].
struct Mux {
  Inputs u{};
  Output<> y{};

  void outputs() {
    Index next = 0;
    STEPWIRE_UNROLLED
    for (Index i = 0; i < u.count(); ++i) {
      STEPWIRE_UNROLLED
      for (Index k = 0; k < u[i].size; ++k) y[next++] = u[i][k];
    }
  }

  static void declare(Declare<Mux>& is);
};

}  // namespace stepwire

#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Vertical concatenation of matrices.
struct Stack {
  Inputs u{};
  Output<> y{};
  Index rows = 0, columns = 0;

  void outputs() {
    Index first = 0;
    for (Index i = 0; i < u.count(); ++i) {
      const Index own = u[i].size / columns;
      for (Index column = 0; column < columns; ++column)
        for (Index row = 0; row < own; ++row) y[column * rows + first + row] = u[i][column * own + row];
      first += own;
    }
  }

  static void declare(Declare<Stack>& is);
};

}  // namespace stepwire

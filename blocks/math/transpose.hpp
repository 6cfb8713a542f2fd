#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Transpose of a matrix: y = u'.
struct Transpose {
  Input<> u{};
  Output<> y{};
  Index rows = 0, columns = 0;

  void outputs() {
    for (Index row = 0; row < rows; ++row)
      for (Index column = 0; column < columns; ++column) y[row * columns + column] = u[column * rows + row];
  }

  static void declare(Declare<Transpose>& is);
};

}  // namespace stepwire

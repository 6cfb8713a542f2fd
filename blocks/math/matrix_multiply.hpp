#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Product of two matrices: y = a b; a vector is a matrix of one column.
struct MatrixMultiply {
  Input<> a{}, b{};
  Output<> y{};
  Index rows = 0, inner = 0, columns = 0;

  void outputs() {
    for (Index column = 0; column < columns; ++column)
      for (Index row = 0; row < rows; ++row) {
        double sum = a[row] * b[column * inner];
        for (Index k = 1; k < inner; ++k) sum += a[k * rows + row] * b[column * inner + k];
        y[column * rows + row] = sum;
      }
  }

  static void declare(Declare<MatrixMultiply>& is);
};

}  // namespace stepwire

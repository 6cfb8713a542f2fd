#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Product of a constant matrix and a vector: y = gain u.
struct MatrixGain {
  Matrix gain{1, 1, {1.0}};
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Index row = 0; row < y.size(); ++row) {
      double sum = gain(row, 0) * u[0];
      for (Index column = 1; column < u.size(); ++column) sum += gain(row, column) * u[column];
      y[row] = sum;
    }
  }

  static void declare(Declare<MatrixGain>& is);
};

}  // namespace stepwire

#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Multiplies signals element by element: y = u1 u2 ...
struct Product {
  Inputs u{};
  Output<> y{};

  void outputs() {
    if (y.size() == 1 && u.count() == 2) {  // the most frequent case
      y[0] = u.first(0) * u.first(1);
    } else {
      multiply_all();
    }
  }

  static void declare(Declare<Product>& is);

 private:
  STEPWIRE_RARE void multiply_all() {
    for (Index k = 0; k < y.size(); ++k) {
      double product = u[0][k];
      for (Index i = 1; i < u.count(); ++i) product *= u[i][k];
      y[k] = product;
    }
  }
};

}  // namespace stepwire

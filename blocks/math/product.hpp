#pragma once

#include "engine/block/block.hpp"

namespace stepwire {

/// Multiplies signals element by element: y = u1 u2 ...
struct Product {
  Inputs u{};
  Output<> y{};

  void outputs() {
    const Index inputs = u.count();
    if (y.size() == 1 && inputs == 2) {  // most of all products
      y[0] = u.first(0) * u.first(1);
      return;
    }
    for (Index k = 0; k < y.size(); ++k) {
      double product = u[0][k];
      for (Index i = 1; i < inputs; ++i) product *= u[i][k];
      y[k] = product;
    }
  }

  static void declare(Declare<Product>& is);
};

}  // namespace stepwire

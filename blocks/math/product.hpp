#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Multiplies signals element by element: y = u1 u2 ...
struct Product {
  Inputs u{};
  Output<> y{};

  void outputs() {
    const Eigen::Index inputs = u.count();
    for (Eigen::Index k = 0; k < y.size(); ++k) {
      double product = u[0][k];
      for (Eigen::Index i = 1; i < inputs; ++i) product *= u[i][k];
      y.coeffRef(k) = product;
    }
  }

  static void declare(Declare<Product>& is);
};

}  // namespace stepwire

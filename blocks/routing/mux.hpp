#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Numbers and vectors into one vector, one behind the other: y = [u1, u2, ...].
struct Mux {
  Inputs u{};
  Output<> y{};

  void outputs() {
    Eigen::Index next = 0;
    for (Eigen::Index i = 0; i < u.count(); ++i) {
      const auto piece = u.view(i);
      for (Eigen::Index k = 0; k < piece.size(); ++k) y.coeffRef(next++) = piece.coeff(k);
    }
  }

  static void declare(Declare<Mux>& is);
};

}  // namespace stepwire

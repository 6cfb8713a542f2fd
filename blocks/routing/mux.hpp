#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Numbers into one vector: y = [u1, u2, ...].
struct Mux {
  Inputs u{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index k = 0; k < y.size(); ++k) y.coeffRef(k) = u[k][0];
  }

  void configure(Configure& is) { is.size("n", is.count<&Mux::u>()); }
  static void declare(Declare<Mux>& is);
};

}  // namespace stepwire

#pragma once

#include "blocks/plants/bouc_wen_law.hpp"
#include "engine/block/block.hpp"

namespace stepwire {

/// The bare Bouc-Wen element, dz/dt = A v - beta |v| |z|^(n-1) z - gamma v |z|^n, with any parameters.
struct BoucWen {
  PerElement A = 1.0, beta = 0.5, gamma = 0.5, n = 1.0;
  Input<> velocity{};
  Output<> z{};
  State<> z_{};

  void derivatives() {
    for (Index i = 0; i < z_.size(); ++i) {
      const BoucWenLaw law{A[i], beta[i], gamma[i], n[i]};
      z_.dot[i] = law.rate(velocity[i], z_[i]);
    }
  }

  static void declare(Declare<BoucWen>& is);
};

}  // namespace stepwire

#pragma once

#include "blocks/plants/bouc_wen_law.hpp"
#include "engine/model/block/block.hpp"

namespace stepwire {

/// Bouc-Wen element, dz/dt = A v - beta |v| |z|^(n-1) z - gamma v |z|^n, with any parameters.
struct BoucWen {
  PerElement A = 1.0, beta = 0.5, gamma = 0.5, n = 1.0;
  PerElement z_max = 0.0, ratio = 0.0;  ///< limit of z and gamma/beta; 0: beta and gamma apply
  Input<> velocity{};
  Output<> z{};
  State<> z_{};

  void derivatives() {
    for (Index i = 0; i < z_.size(); ++i) {
      const BoucWenLaw law = law_of(i);
      z_.derivative[i] = law.rate(velocity[i], z_[i]);
    }
  }

  static void declare(Declare<BoucWen>& is);

 private:
  BoucWenLaw law_of(Index i) const {
    return z_max[i] > 0.0 ? BoucWenLaw::of_limit(A[i], z_max[i], ratio[i], n[i])
                          : BoucWenLaw{{A[i], beta[i], gamma[i]}, n[i]};
  }
};

}  // namespace stepwire

#pragma once

#include "blocks/plants/bouc_wen_law.hpp"
#include "engine/block/declare.hpp"

namespace stepwire {

/// The bare Bouc-Wen element, dz/dt = A v - beta |v| |z|^(n-1) z - gamma v |z|^n, with any parameters.
struct BoucWen {
  PerElement A = 1.0, beta = 0.5, gamma = 0.5, n = 1.0;
  Input<> velocity{};
  Output<> z{};
  State<> z_{};

  void derivatives() {
    for (Eigen::Index i = 0; i < z_.size(); ++i) {
      const BoucWenLaw law{A.coeff(i), beta.coeff(i), gamma.coeff(i), n.coeff(i)};
      z_.dot.coeffRef(i) = law.rate(velocity.coeff(i), z_.coeff(i));
    }
  }

  static void declare(Declare<BoucWen>& is);
};

}  // namespace stepwire

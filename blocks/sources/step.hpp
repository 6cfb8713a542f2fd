#pragma once

#include "blocks/sources/instant.hpp"
#include "engine/block/declare.hpp"

namespace stepwire {

/// A jump from one value to another: y = before for t < time, else y = after.
struct Step {
  PerElement time = 1.0, before = 0.0, after = 1.0;
  Output<> y{};
  Time t{};

  void outputs() {
    for (Eigen::Index k = 0; k < y.size(); ++k)
      y.coeffRef(k) = reached(t, time.coeff(k)) ? after.coeff(k) : before.coeff(k);
  }

  static void declare(Declare<Step>& is);
};

}  // namespace stepwire

#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"

namespace stepwire {

/// Play of a gear: the output moves only where the input pushes it at one end of the gap.
struct Backlash {
  PerElement width = 1.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> last{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = pushed(i);
  }

  void update() {
    for (Eigen::Index i = 0; i < last.size(); ++i) last.coeffRef(i) = pushed(i);
  }

  static void declare(Declare<Backlash>& is);

 private:
  double pushed(Eigen::Index i) const {
    const double half = width.coeff(i) / 2.0;
    return std::clamp(last.coeff(i), u.coeff(i) - half, u.coeff(i) + half);
  }
};

}  // namespace stepwire

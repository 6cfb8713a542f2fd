#pragma once

#include "engine/block/declare.hpp"
#include "engine/block/limits.hpp"

namespace stepwire {

/// A threshold that does not flutter: becomes 1 at an upper and 0 at a lower one.
struct Hysteresis {
  PerElement lower = 0.0, upper = 0.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> last{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = holds(i) ? 1.0 : 0.0;
  }

  void update() {
    for (Eigen::Index i = 0; i < last.size(); ++i) last.coeffRef(i) = holds(i) ? 1.0 : 0.0;
  }

  void configure(Configure& is) { require_order<&Hysteresis::lower, &Hysteresis::upper>(*this, is); }
  static void declare(Declare<Hysteresis>& is);

 private:
  bool holds(Eigen::Index i) const {
    if (u.coeff(i) >= upper.coeff(i)) return true;
    return u.coeff(i) > lower.coeff(i) && last.coeff(i) > 0.0;
  }
};

}  // namespace stepwire

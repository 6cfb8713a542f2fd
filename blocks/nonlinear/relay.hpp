#pragma once

#include "engine/block/declare.hpp"
#include "engine/block/limits.hpp"

namespace stepwire {

/// Switches between two values, on at an upper and off at a lower threshold.
struct Relay {
  PerElement switch_on = 0.0, switch_off = 0.0, when_on = 1.0, when_off = 0.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> on{};

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i)
      y.coeffRef(i) = is_on(i) ? when_on.coeff(i) : when_off.coeff(i);
  }

  void update() {
    for (Eigen::Index i = 0; i < on.size(); ++i) on.coeffRef(i) = is_on(i) ? 1.0 : 0.0;
  }

  void configure(Configure& is) { require_order<&Relay::switch_off, &Relay::switch_on>(*this, is); }
  static void declare(Declare<Relay>& is);

 private:
  bool is_on(Eigen::Index i) const {
    if (u.coeff(i) >= switch_on.coeff(i)) return true;
    return u.coeff(i) > switch_off.coeff(i) && on.coeff(i) > 0.0;
  }
};

}  // namespace stepwire

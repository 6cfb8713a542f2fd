#pragma once

#include "blocks/plants/linkage_core.hpp"

namespace stepwire {

/// Links from the ground to one pin, moved by forces: M(p) a + h(p, v) = external + sum of force e + torque/l
/// n.
struct Linkage : LinkageCore {
  Input<> external{};
  Output<> position{}, velocity{};
  State<> position_{}, velocity_{};

  void outputs() {
    position = position_;
    velocity = velocity_;
    in_dimension([&](auto n) {
      double energy = energy_of_pin(n, velocity_);
      STEPWIRE_UNROLLED
      for (Index k = 0; k < links(); ++k) write_link(k, link(n, k, position_, velocity_), energy);
      kinetic_energy = energy;
    });
  }

  void derivatives() {
    position_.derivative = velocity_;
    in_dimension([&](auto n) { write_acceleration(n); });
  }

  void update() { watch_stroke(); }

  void configure(Configure& is);
  static void declare(Declare<Linkage>& is);

 private:
  template <Index n>
  void write_acceleration(Dimension<n> dimension) {
    Balance<n> now;  // never returned from a function: lanes have no vector of whole structures
    add_pin(now);
    STEPWIRE_UNROLLED
    for (Index k = 0; k < links(); ++k) add_link(k, link(dimension, k, position_, velocity_), now);
    STEPWIRE_UNROLLED
    for (Index i = 0; external.connected() && i < n; ++i) at(now.load, i) += external[i];
    solve(now);
    STEPWIRE_UNROLLED
    for (Index i = 0; i < n; ++i) velocity_.derivative[i] = at(now.load, i);
  }

  /// Replaces the load by the acceleration. M is symmetric and positive definite, so no pivoting is needed.
  template <Index n>
  void solve(Balance<n>& now) const {
    STEPWIRE_UNROLLED
    for (Index j = 0; j < n; ++j) {
      STEPWIRE_UNROLLED
      for (Index i = j + 1; i < n; ++i) {
        const double factor = at(row(now, i), j) / at(row(now, j), j);
        STEPWIRE_UNROLLED
        for (Index k = j; k < n; ++k) at(row(now, i), k) -= factor * at(row(now, j), k);
        at(now.load, i) -= factor * at(now.load, j);
      }
    }
    STEPWIRE_UNROLLED
    for (Index i = n; i-- > 0;) {
      STEPWIRE_UNROLLED
      for (Index k = i + 1; k < n; ++k) at(now.load, i) -= at(row(now, i), k) * at(now.load, k);
      at(now.load, i) /= at(row(now, i), i);
    }
  }
};

}  // namespace stepwire

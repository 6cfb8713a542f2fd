#pragma once

#include "blocks/plants/linkage_core.hpp"

namespace stepwire {

/// Links from the ground to one pin with prescribed motion: external = M(p) a + h(p, v) - sum of (force e +
/// torque/l n).
struct DrivenLinkage : LinkageCore {
  Input<> position{}, velocity{}, acceleration{};
  Output<> external{};

  void outputs() {
    in_dimension([&](auto n) { write_outputs(n); });
  }

  void update() { watch_stroke(); }

  void configure(Configure& is);
  static void declare(Declare<DrivenLinkage>& is);

 private:
  template <Index n>
  void write_outputs(Dimension<n> dimension) {
    double energy = energy_of_pin(dimension, velocity);
    Balance<n> now;
    add_pin(now);
    STEPWIRE_UNROLLED
    for (Index k = 0; k < links(); ++k) {
      const Link<n> is = link(dimension, k, position, velocity);
      write_link(k, is, energy);
      add_link(k, is, now);
    }
    kinetic_energy = energy;
    unrolled<n>([&](Index i) { external[i] = inertial(now, i) - at(now.load, i); });
  }

  template <Index n>
  double inertial(Balance<n>& now, Index i) const {
    double sum = 0.0;
    if (acceleration.connected()) unrolled<n>([&](Index j) { sum += at(row(now, i), j) * acceleration[j]; });
    return sum;
  }
};

}  // namespace stepwire

#pragma once

#include "blocks/plants/linkage_core.hpp"

namespace stepwire {

/// Links from the ground to one pin with prescribed motion: external = M(p) a + h(p, v) - sum of (force e +
/// torque/l n).
struct DrivenLinkage : LinkageCore {
  Input<> position{}, velocity{}, acceleration{};
  Output<> external{};

  void outputs() {
    begin_energy(velocity);
    Balance now = begin_balance();
    for_each_link(position, velocity, [&](auto n, Index k, const Link& link) {
      write_link(n, k, link);
      add_link(n, k, link, now);
    });
    external.each([&](Index i) { return inertial(now, i) - at(now.load, i); });
  }

  void update() { watch_stroke(); }

  void configure(Configure& is);
  static void declare(Declare<DrivenLinkage>& is);

 private:
  double inertial(Balance& now, Index i) const {
    double sum = 0.0;
    for (Index j = 0; acceleration.connected() && j < dimensions(); ++j)
      sum += at(row(now, i), j) * acceleration[j];
    return sum;
  }
};

}  // namespace stepwire

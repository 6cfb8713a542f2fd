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
    begin_energy(velocity_);
    for_each_link(position_, velocity_, [&](auto n, Index k, const Link& now) { write_link(n, k, now); });
  }

  void derivatives() {
    Balance now = begin_balance();
    for_each_link(position_, velocity_,
                  [&](auto n, Index k, const Link& link) { add_link(n, k, link, now); });
    for (Index i = 0; external.connected() && i < dimensions(); ++i) at(now.load, i) += external[i];
    solve(now);
    position_.derivative = velocity_;
    velocity_.derivative.each([&](Index i) { return at(now.load, i); });
  }

  void update() { watch_stroke(); }

  void configure(Configure& is);
  static void declare(Declare<Linkage>& is);

 private:
  /// Replaces the load by the acceleration. M is symmetric and positive definite, so no pivoting is needed.
  void solve(Balance& now) const {
    const Index size = dimensions();
    for (Index j = 0; j < size; ++j)
      for (Index i = j + 1; i < size; ++i) {
        const double factor = at(row(now, i), j) / at(row(now, j), j);
        for (Index k = j; k < size; ++k) at(row(now, i), k) -= factor * at(row(now, j), k);
        at(now.load, i) -= factor * at(now.load, j);
      }
    for (Index i = size; i-- > 0;) {
      for (Index k = i + 1; k < size; ++k) at(now.load, i) -= at(row(now, i), k) * at(now.load, k);
      at(now.load, i) /= at(row(now, i), i);
    }
  }
};

}  // namespace stepwire

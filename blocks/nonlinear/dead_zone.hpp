#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Zero within a zone, and how far the input lies outside of it elsewhere.
struct DeadZone {
  PerElement lower = -0.5, upper = 0.5;
  Input<> u{};
  Output<> y{};

  bool wired = false;  // is an end of the zone a signal?
  Input<> lower_{}, upper_{};

  void outputs() {
    if (wired) {
      leave_zone_of_signals();
    } else {
      y.each([&](Index i) { return u[i] - std::clamp(u[i], lower[i], upper[i]); });
    }
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) {
      zero.add(u[i] - (lower_.connected() ? lower_[i] : lower[i]));
      zero.add(u[i] - (upper_.connected() ? upper_[i] : upper[i]));
    }
  }

  void configure(Configure& is);
  static void declare(Declare<DeadZone>& is);

 private:
  /// Signals may cross: the upper one holds then.
  STEPWIRE_RARE void leave_zone_of_signals() {
    for (Index i = 0; i < y.size(); ++i)
      y[i] = u[i] - std::min(std::max(u[i], lower_.connected() ? lower_[i] : lower[i]),
                             upper_.connected() ? upper_[i] : upper[i]);
  }
};

}  // namespace stepwire

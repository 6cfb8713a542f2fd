#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The input within limits: y = min(max(u, lower), upper).
struct Saturation {
  PerElement lower = -unlimited, upper = unlimited;
  Input<> u{};
  Output<> y{};

  bool wired = false;  // is a limit a signal?
  Input<> lower_{}, upper_{};

  void outputs() {
    if (wired) {
      limit_by_signals();
    } else {
      y.each([&](Index i) { return std::clamp(u[i], lower[i], upper[i]); });
    }
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) {
      zero.add(u[i] - (lower_.connected() ? lower_[i] : lower[i]));
      zero.add(u[i] - (upper_.connected() ? upper_[i] : upper[i]));
    }
  }

  void configure(Configure& is);
  static void declare(Declare<Saturation>& is);

 private:
  /// Signals may cross: the upper one holds then.
  STEPWIRE_RARE void limit_by_signals() {
    for (Index i = 0; i < y.size(); ++i)
      y[i] = std::min(std::max(u[i], lower_.connected() ? lower_[i] : lower[i]),
                      upper_.connected() ? upper_[i] : upper[i]);
  }
};

}  // namespace stepwire

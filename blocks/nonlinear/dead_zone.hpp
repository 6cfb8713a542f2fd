#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Dead zone: zero within the zone, outside of it the distance from its nearer end.
struct DeadZone {
  PerElement lower = -0.5, upper = 0.5;
  Input<> u{};
  Output<> y{};
  Input<> lower_{}, upper_{};  // replace the parameters if connected

  void outputs() {
    y.each([&](Index i) { return u[i] - limited(i); });
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) {
      zero.add(u[i] - low(i));
      zero.add(u[i] - high(i));
    }
  }

  void configure(Configure& is);
  static void declare(Declare<DeadZone>& is);

 private:
  double low(Index i) const { return lower_.connected() ? lower_[i] : lower[i]; }
  double high(Index i) const { return upper_.connected() ? upper_[i] : upper[i]; }
  /// Limits the input; of crossed limits the upper one applies.
  double limited(Index i) const { return std::min(std::max(u[i], low(i)), high(i)); }
};

}  // namespace stepwire

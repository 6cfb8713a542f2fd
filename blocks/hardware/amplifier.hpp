#pragma once

#include <algorithm>
#include <numbers>

#include "engine/block/block.hpp"

namespace stepwire {

/// A power amplifier in current mode: tau di/dt = wanted - i, wanted = gain u within [lower, upper].
struct Amplifier {
  PerElement gain = 1.0, lower = -unlimited, upper = unlimited, tau = 1e-3;
  Input<> u{};
  Output<> current{};
  State<> current_{};
  Notice at_limit{};
  Time time{};

  void derivatives() {
    current_.dot.each([&](Index i) { return (wanted(i) - current_[i]) / tau[i]; });
  }
  void update() {
    for (Index i = 0; i < u.size(); ++i)
      if (gain[i] * u[i] != wanted(i)) at_limit.raise(time);
  }

  void configure(Configure& is);
  static void declare(Declare<Amplifier>& is);

 private:
  double wanted(Index i) const { return std::clamp(gain[i] * u[i], lower[i], upper[i]); }
};

/// Peak current of the datasheet. The bandwidth of 2.5 kHz is assumed, from its sister series.
inline void amc_16a20ac(Amplifier& amplifier) {
  amplifier.lower = -16.0;
  amplifier.upper = 16.0;
  amplifier.tau = 1.0 / (2.0 * std::numbers::pi * 2500.0);
}

}  // namespace stepwire

#pragma once

#include <algorithm>
#include <numbers>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Power amplifier in current mode: tau di/dt = w - i. The command w is gain u within [lower, upper], or 0
/// while the amplifier is inhibited.
struct Amplifier {
  PerElement gain = 1.0, lower = -unlimited, upper = unlimited, tau = 1e-3;
  Input<> u{};
  Input<1> inhibit{};
  Output<> current{};
  State<> current_{};
  Diagnostic at_limit{};
  Time time{};

  void derivatives() {
    current_.derivative.each([&](Index i) { return (wanted(i) - current_[i]) / tau[i]; });
  }
  void update() {
    for (Index i = 0; i < u.size(); ++i)
      if (gain[i] * u[i] != limited(i)) at_limit.raise(time);
  }

  void configure(Configure& is);
  static void declare(Declare<Amplifier>& is);

 private:
  /// True if inhibited; also for an input that is NaN.
  bool inhibited() const { return inhibit.connected() && !(inhibit <= 0.0); }
  double limited(Index i) const { return std::clamp(gain[i] * u[i], lower[i], upper[i]); }
  double wanted(Index i) const { return inhibited() ? 0.0 : limited(i); }
};

/// Peak current of the datasheet. The bandwidth of 2.5 kHz is assumed, from its sister series.
inline void amc_16a20ac(Amplifier& amplifier) {
  amplifier.lower = -16.0;
  amplifier.upper = 16.0;
  amplifier.tau = 1.0 / (2.0 * std::numbers::pi * 2500.0);
}

}  // namespace stepwire

#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// First-order lag: tau dx/dt = gain u - x, y = x.
struct Lag {
  PerElement tau = 1.0, gain = 1.0;
  Input<> u{};
  Output<> y{};
  State<> x{};

  PerElement decay = 1.0;  // 1 / tau: every stage of every step waits for its slope, and a division is slow

  void derivatives() {
    x.dot.each([&](Index i) { return (gain[i] * u[i] - x[i]) * decay[i]; });
  }

  void prepare() {
    decay = tau.map([](double seconds) { return 1.0 / seconds; });
  }
  static void declare(Declare<Lag>& is);
};

}  // namespace stepwire

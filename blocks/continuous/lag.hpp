#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// First-order lag: tau dx/dt = gain u - x, y = x.
struct Lag : Resettable {
  PerElement tau = 1.0, gain = 1.0;
  Input<> u{};
  Output<> y{};
  State<> x{};

  PerElement decay = 1.0;  // 1 / tau; faster than a division in every stage

  /// Runs only if something resets, like update().
  void outputs() { y = x; }
  void outputs_at_instant() {
    const bool now = resetting();
    for (Index i = 0; i < y.size(); ++i) y[i] = now ? target(i) : x[i];
  }

  void derivatives() {
    if (resets && held()) {
      x.derivative = 0.0;
    } else {
      x.derivative.each([&](Index i) { return (gain[i] * u[i] - x[i]) * decay[i]; });
    }
  }

  void update() {
    if (resetting())
      for (Index i = 0; i < x.size(); ++i) x[i] = target(i);
    remember_reset();
  }

  void configure(Configure& is);
  void prepare() {
    decay = tau.map([](double seconds) { return 1.0 / seconds; });
  }
  void start() { home = x; }
  static void declare(Declare<Lag>& is);
};

}  // namespace stepwire

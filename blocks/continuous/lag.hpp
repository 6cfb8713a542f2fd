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
  void outputs() { show(held()); }
  void outputs_at_instant() { show(resetting()); }

  void derivatives() {
    if (resets && held()) {
      x.derivative = 0.0;
    } else {
      x.derivative.each([&](Index i) { return (gain[i] * u[i] - x[i]) * decay[i]; });
    }
  }

  void update_before_instant() { follow_target(x); }
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

 private:
  void show(bool at_target) {
    for (Index i = 0; i < y.size(); ++i) y[i] = at_target ? target(i) : x[i];
  }
};

}  // namespace stepwire

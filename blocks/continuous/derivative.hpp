#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// Filtered derivative, s / (tau s + 1): tau dx/dt = u - x, y = (u - x) / tau.
struct Derivative {
  PerElement tau = 1e-3;
  bool settled = false;
  Input<> u{};
  Output<> y{};
  State<> x{};
  DiscreteState<1> begun{};

  void outputs() {
    if (settled && begun == 0.0) {
      y = 0.0;
    } else {
      y = (u - x) / tau;
    }
  }

  void derivatives() { x.dot = (u - x) / tau; }

  /// Runs only where the start is settled.
  void update() {
    if (begun == 0.0) x = u;
    begun = 1.0;
  }

  void configure(Configure& is) {
    if (!settled) is.skip_update();
  }
  static void declare(Declare<Derivative>& is);
};

}  // namespace stepwire

#pragma once

#include "engine/model/block/block.hpp"

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
      for (Index i = 0; i < y.size(); ++i) y[i] = rate(i);
    }
  }

  void derivatives() {
    for (Index i = 0; i < x.size(); ++i) x.dot[i] = rate(i);
  }

  /// Runs only where the start is settled.
  void update() {
    if (begun == 0.0) x = u;
    begun = 1.0;
  }

  void configure(Configure& is);
  static void declare(Declare<Derivative>& is);

 private:
  double rate(Index i) const { return (u[i] - x[i]) / tau[i]; }
};

}  // namespace stepwire

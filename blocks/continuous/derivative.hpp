#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Filtered derivative, s / (tau s + 1): tau dx/dt = u - x, y = (u - x) / tau.
struct Derivative : Resettable {
  PerElement tau = 1e-3;
  bool settled = false;
  Input<> u{};
  Output<> y{};
  State<> x{};
  DiscreteState<1> begun{};

  void outputs() { follow(x); }
  void outputs_at_instant() {
    const bool now = resetting();
    if (settled && (now || begun == 0.0)) {
      y = 0.0;
    } else if (now) {
      follow(Targets{*this});
    } else {
      follow(x);
    }
  }

  void derivatives() {
    const bool still = held();
    for (Index i = 0; i < x.size(); ++i) x.derivative[i] = still ? 0.0 : (u[i] - x[i]) / tau[i];
  }

  /// Runs only where the start is settled, or something resets.
  void update() {
    const bool now = resetting();
    if (settled && (now || begun == 0.0)) {
      x = u;
    } else if (now) {
      x = Targets{*this};
    }
    begun = 1.0;
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<Derivative>& is);

 private:
  template <class States>
  void follow(const States& states) {
    for (Index i = 0; i < y.size(); ++i) y[i] = (u[i] - states[i]) / tau[i];
  }
};

}  // namespace stepwire

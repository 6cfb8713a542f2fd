#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Filtered derivative, s / (tau s + 1): tau dx/dt = u - x, y = (u - x) / tau.
struct Derivative : Resettable {
  PerElement tau = 1e-3;
  bool settled = true;
  Input<> u{};
  Output<> y{};
  State<> x{};
  DiscreteState<1> begun{};

  bool follows = true;  // true if settled, without an initial value

  void outputs() { show_side(held() && settles_at_reset(), held()); }
  void outputs_at_instant() { show_side(settles(), resetting()); }

  void derivatives() {
    const bool still = held();
    for (Index i = 0; i < x.size(); ++i) x.derivative[i] = still ? 0.0 : (u[i] - x[i]) / tau[i];
  }

  void update_before_instant() {
    if (held()) restart(settles_at_reset());
  }
  /// Runs only if the filter follows the input, or something resets.
  void update() {
    if (settles() || resetting()) restart(settles());
    begun = 1.0;
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<Derivative>& is);

 private:
  /// True at the first instant and at a reset, unless the filter has a given value.
  bool settles() const { return follows && (resetting() ? !value.connected() : begun == 0.0); }
  bool settles_at_reset() const { return follows && !value.connected(); }
  void show_side(bool at_input, bool at_target) {
    if (at_input) {
      y = 0.0;
    } else if (at_target) {
      show(Targets{*this});
    } else {
      show(x);
    }
  }
  void restart(bool at_input) {
    if (at_input) {
      x = u;
    } else {
      x = Targets{*this};
    }
  }
  template <class States>
  void show(const States& states) {
    for (Index i = 0; i < y.size(); ++i) y[i] = (u[i] - states[i]) / tau[i];
  }
};

}  // namespace stepwire

#pragma once

#include "engine/model/block/linear_system.hpp"

namespace stepwire {

/// Linear system: dx/dt = A x + B u, y = C x + D u.
struct StateSpace : LinearSystem {
  Output<> y{};
  State<> x{};

  void outputs() { held() ? show(Targets{*this}) : show(x); }
  void outputs_at_instant() { resetting() ? show(Targets{*this}) : show(x); }

  void derivatives() {
    x.derivative = 0.0;
    if (held()) return;
    dense::add(A, x, x.derivative);
    dense::add(B, u, x.derivative);
  }

  void update_before_instant() { follow_target(x); }
  /// Runs only if something resets.
  void update() {
    if (resetting()) x = Targets{*this};
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<StateSpace>& is);

 private:
  template <class States>
  void show(const States& states) {
    y = 0.0;
    dense::add(C, states, y);
    if (direct) dense::add(D, u, y);
  }
};

}  // namespace stepwire

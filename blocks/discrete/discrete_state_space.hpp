#pragma once

#include "engine/model/block/linear_system.hpp"

namespace stepwire {

/// Linear system at its ticks: x[k+1] = A x[k] + B u[k], y[k] = C x[k] + D u[k].
struct DiscreteStateSpace : LinearSystem {
  Output<> y{};
  DiscreteState<> x{};
  DiscreteState<> next{};  // memory for the next x

  void outputs() {
    y = 0.0;
    if (resetting()) {
      dense::add(C, Targets{*this}, y);
    } else {
      dense::add(C, x, y);
    }
    if (direct) dense::add(D, u, y);
  }

  void update() {
    if (resetting()) x = Targets{*this};
    remember_reset();
    next = 0.0;
    dense::add(A, x, next);
    dense::add(B, u, next);
    x = next;
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<DiscreteStateSpace>& is);
};

}  // namespace stepwire

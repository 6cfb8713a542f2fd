#pragma once

#include "engine/model/block/linear_system.hpp"

namespace stepwire {

/// Observer with a constant gain at its ticks: x[k+1] = A x + B u + L (y - C x - D u).
struct DiscreteLuenbergerObserver : LinearObserver {
  DiscreteState<> x{};
  DiscreteState<> next{};      // memory for the next x
  DiscreteState<> residual{};  // measurement minus its prediction

  void outputs() {
    if (resetting()) {
      estimate = Targets{*this};
    } else {
      estimate = x;
    }
  }

  void update() {
    remember_reset();
    residual = measured;
    dense::add(C, estimate, residual, -1.0);
    if (direct) dense::add(D, u, residual, -1.0);
    next = 0.0;
    dense::add(A, estimate, next);
    if (u.connected()) dense::add(B, u, next);
    dense::add(L, residual, next);
    x = next;
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<DiscreteLuenbergerObserver>& is);
};

}  // namespace stepwire

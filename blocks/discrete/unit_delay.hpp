#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Delay by one period: y[k] = u[k-1].
struct UnitDelay : Resettable {
  Input<> u{};
  Output<> y{};
  DiscreteState<> x{};

  void outputs() {
    if (resets && resetting()) {
      y = Targets{*this};
    } else {
      y = x;
    }
  }

  void update() {
    x = u;
    if (resets) remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }

  static void declare(Declare<UnitDelay>& is);
};

}  // namespace stepwire

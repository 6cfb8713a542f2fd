#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Delay by one period: y[k] = u[k-1].
struct UnitDelay {
  Input<> u{};
  Output<> y{};
  DiscreteState<> x{};

  void outputs() { y = x; }
  void update() { x = u; }

  static void declare(Declare<UnitDelay>& is);
};

}  // namespace stepwire

#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Threshold with hysteresis: becomes 1 at an upper and 0 at a lower threshold.
struct Hysteresis {
  PerElement lower = 0.0, upper = 0.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> last{};

  void outputs() {
    y.each([&](Index i) { return holds(i) ? 1.0 : 0.0; });
  }

  void update() {
    for (Index i = 0; i < last.size(); ++i) last[i] = holds(i) ? 1.0 : 0.0;
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) zero.add(u[i] - (last[i] > 0.0 ? lower[i] : upper[i]));
  }

  void configure(Configure& is);
  static void declare(Declare<Hysteresis>& is);

 private:
  bool holds(Index i) const {
    if (u[i] >= upper[i]) return true;
    return u[i] > lower[i] && last[i] > 0.0;
  }
};

}  // namespace stepwire

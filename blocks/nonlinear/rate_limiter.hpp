#pragma once

#include <algorithm>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Follows its input, but no faster than its rates allow.
struct RateLimiter {
  PerElement rising = 1.0, falling = -1.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> last{};
  DiscreteState<1> elapsed{};  // since the last tick: none at the first one
  Period period{};

  void outputs() {
    for (Index i = 0; i < y.size(); ++i) y[i] = reached(i);
  }

  void update() {
    for (Index i = 0; i < last.size(); ++i) last[i] = reached(i);
    elapsed = period;
  }

  static void declare(Declare<RateLimiter>& is);

 private:
  double reached(Index i) const {
    const double from = last[i];
    return std::clamp(u[i], from + falling[i] * elapsed, from + rising[i] * elapsed);
  }
};

}  // namespace stepwire

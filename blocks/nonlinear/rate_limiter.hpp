#pragma once

#include <algorithm>

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Follows its input with limited rates.
struct RateLimiter : Resettable {
  PerElement rising = 1.0, falling = -1.0;
  Input<> u{}, rising_{}, falling_{};
  Output<> y{};
  DiscreteState<> last{};
  DiscreteState<1> elapsed{};  // time since the last tick; 0 at the first tick
  Period period{};

  void outputs() {
    for (Index i = 0; i < y.size(); ++i) y[i] = reached(i);
  }

  void update() {
    for (Index i = 0; i < last.size(); ++i) last[i] = reached(i);
    elapsed = period;
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = last; }
  static void declare(Declare<RateLimiter>& is);

 private:
  /// Returns the rising rate. A rate signal of the wrong sign counts as 0 and holds the output.
  double fastest_rise(Index i) const { return rising_.connected() ? std::max(rising_[i], 0.0) : rising[i]; }
  double fastest_fall(Index i) const {
    return falling_.connected() ? std::min(falling_[i], 0.0) : falling[i];
  }
  double reached(Index i) const {
    if (resetting()) return target(i);
    const double from = last[i];
    return std::clamp(u[i], from + fastest_fall(i) * elapsed, from + fastest_rise(i) * elapsed);
  }
};

}  // namespace stepwire

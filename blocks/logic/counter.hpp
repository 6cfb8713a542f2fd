#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Counts edges of its input, or its ticks, within limits at which it stops or wraps around.
struct Counter : Resettable {
  enum class Beyond { hold, wrap };

  Trigger count_at = Trigger::rising;
  double step = 1.0, lower = -unlimited, upper = unlimited;
  Beyond beyond = Beyond::hold;
  Input<1> u{}, down{};
  Output<1> y{};
  DiscreteState<1> count{};
  DiscreteState<1> last{};  // input at the last tick: -1 false, 1 true, 0 unknown

  void outputs() { y = counted(); }

  void update() {
    count = counted();
    last = u.connected() && u > 0.0 ? 1.0 : -1.0;
    remember_reset();
  }

  void crossings(Crossings& zero) const {
    Resettable::crossings(zero);
    zero.add_connected(u);
  }

  void configure(Configure& is);
  void start() { home[0] = count; }
  static void declare(Declare<Counter>& is);

 private:
  /// True if this tick counts; without an input, every tick but the first.
  bool counts() const { return u.connected() ? fires(count_at, last, u > 0.0) : last != 0.0; }
  double counted() const {
    if (resetting()) return target(0);
    if (!counts()) return count;
    const double next = down.connected() && down > 0.0 ? count - step : count + step;
    if (next > upper) return beyond == Beyond::hold ? upper : lower;
    if (next < lower) return beyond == Beyond::hold ? lower : upper;
    return next;
  }
};

}  // namespace stepwire

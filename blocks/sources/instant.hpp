#pragma once

#include <cmath>
#include <limits>

namespace stepwire {

/// Has `now` reached `instant`? Ticks are products such as 3 * 0.1 s, an instant is a number that somebody
/// wrote: both are rounded, and a step must not come one tick late for the last bit.
inline bool reached(double now, double instant) {
  return now >= instant - 8.0 * std::numeric_limits<double>::epsilon() * std::abs(instant);
}

}  // namespace stepwire

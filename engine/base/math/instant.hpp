#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire {

/// Has `now` reached `instant`? Ticks are products such as 3 * 0.1 s, an instant is a number that somebody
/// wrote: both are rounded, and a step must not come one tick late for the last bit.
inline bool reached(double now, double instant) {
  return now >= instant - 8.0 * std::numeric_limits<double>::epsilon() * std::abs(instant);
}

/// The first of two instants that `now` has not reached; infinite where it has reached both.
inline double first_ahead(double now, double instant,
                          double other = std::numeric_limits<double>::infinity()) {
  const double last = std::numeric_limits<double>::infinity();
  return std::min(reached(now, instant) ? last : instant, reached(now, other) ? last : other);
}

}  // namespace stepwire

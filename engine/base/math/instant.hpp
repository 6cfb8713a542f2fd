#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepwire {

/// Returns the time since an instant, which is moved back by rounding. Ticks are products such as 3 * 0.1 s
/// and instants are literals; both are rounded, and a step must not be a tick late for the last bit.
inline double time_since(double instant, double now) {
  return now - (instant - 8.0 * std::numeric_limits<double>::epsilon() * std::abs(instant));
}

/// True where `now` is at or after `instant`, within rounding.
inline bool reached(double now, double instant) {
  return time_since(instant, now) >= 0.0;
}

/// Returns the earlier of two instants that are still ahead of `now`; infinity where both are reached.
inline double first_ahead(double now, double instant,
                          double other = std::numeric_limits<double>::infinity()) {
  const double last = std::numeric_limits<double>::infinity();
  return std::min(reached(now, instant) ? last : instant, reached(now, other) ? last : other);
}

}  // namespace stepwire

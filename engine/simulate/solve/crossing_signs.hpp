#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stepwire::solve {

inline int sign_of(double number) {
  return (number > 0.0) - (number < 0.0);
}

/// True if any number has changed its sign; 0 is a sign of its own. The loop has no branches because every
/// step waits for it.
inline bool sign_changes(const double* before, const double* after, std::size_t count) {
  bool changes = false;
  for (std::size_t i = 0; i < count; ++i)
    changes |= ((before[i] > 0.0) != (after[i] > 0.0)) | ((before[i] < 0.0) != (after[i] < 0.0));
  return changes;
}

/// Part of a step after a tick. A crossing within it is one at the tick that rounding has delayed.
constexpr double after_tick = 1e-9;

/// True if a number has not changed its sign, and would do so within that part of the step at the same rate.
inline bool almost_crosses(const double* before, const double* after, std::size_t count) {
  bool almost = false;
  for (std::size_t i = 0; i < count; ++i)
    almost |= (std::abs(after[i]) < after_tick * std::abs(after[i] - before[i])) & (after[i] != 0.0) &
              ((before[i] > 0.0) == (after[i] > 0.0));
  return almost;
}

/// Returns the first zero among the secants of the numbers that change their sign, as a fraction of the
/// interval from low to high. The scales weight the two ends. A number that leaves 0 is assumed to do so at
/// once if `at_once` is set, else in the middle.
inline double first_secant(const double* start, const double* low, const double* high, std::size_t count,
                           double low_scale, double high_scale, bool at_once) {
  double first = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (sign_of(high[i]) == sign_of(start[i])) continue;
    const double from = low_scale * low[i], to = high_scale * high[i];
    const double part = from == 0.0 && at_once                     ? 0.0
                        : from == 0.0 || !std::isfinite(to - from) ? 0.5
                                                                   : from / (from - to);
    first = std::min(first, part);
  }
  return first;
}

/// Value of past[0] in may_cross_twice() after a step with events.
constexpr double look_closer = -1.0;

/// True if a number may have passed 0 twice within a step, with the same sign at both ends.
///
/// The test is a parabola through the number at the start of the last step and at both ends of this one. It
/// reports a number if its vertex is within the step and comes within half of its rise of 0. After events,
/// and with `from_start` in the first step, there is no parabola and the answer is true. Argument `past`
/// holds the length of the last step and the numbers at its start. Its first entry is look_closer after
/// events and 0 at the start of a run. The numbers at the start of this step are stored in `past`.
inline bool may_cross_twice(const double* before, const double* after, double* past, std::size_t count,
                            bool from_start, double length) {
  bool may = past[0] == look_closer || (past[0] == 0.0 && from_start);
  const double last = past[0] > 0.0 ? past[0] / length : 1.0, scale = 2.0 / (last * (last + 1.0));
  for (std::size_t i = 0; i < count; ++i) {
    const double start = before[i], rise = after[i] - start;
    const double bend = scale * ((past[i + 1] - start) + last * rise), tilt = 2.0 * rise - bend;
    const double least = start - tilt * tilt / (8.0 * bend), side = start > 0.0 ? 1.0 : -1.0;
    const double turn = std::max(std::abs(start - least), std::abs(after[i] - least));
    may |= (tilt * bend < 0.0) & (std::abs(tilt) < 2.0 * std::abs(bend)) & (side * bend > 0.0) &
           (side * least <= 0.5 * turn);
    past[i + 1] = start;
  }
  past[0] = length;
  return may;
}

}  // namespace stepwire::solve

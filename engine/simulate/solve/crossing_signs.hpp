#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

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

/// True if any number has changed its sign between the start and a time before the end. A number that is 0
/// there has not, unless it is 0 at the end: it passes 0, and takes no time for it.
inline bool sign_passes(const double* start, const double* there, const double* end, std::size_t count) {
  bool passes = false;
  for (std::size_t i = 0; i < count; ++i)
    passes |= sign_of(there[i]) != sign_of(start[i]) && (there[i] != 0.0 || end[i] == 0.0);
  return passes;
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

/// Past of the crossing functions: the length of the last step, and four numbers for each function. A band
/// holds the last values of a number that is far from 0 compared with its changes. For other numbers the band
/// is empty, with its lower end above its upper one; `change` is that within the last step, and `bend` is the
/// difference of the last two changes. The length is 0 as long as nothing is known: at the start of a run and
/// after events.
struct CrossingPast {
  CrossingPast(double* numbers, std::size_t functions)
      : length(numbers[0]),
        low(numbers + 1),
        high(low + functions),
        change(high + functions),
        bend(change + functions),
        count(functions) {}
  static constexpr std::size_t size(std::size_t count) { return 1 + 4 * count; }

  void forget() {
    length = 0.0;
    std::fill_n(low, count, 1.0);
    std::fill_n(high, count, -1.0);
  }

  double& length;
  double *low, *high, *change, *bend;
  std::size_t count;
};

/// True if each number is within its band. Numbers that are so at both ends of a step have not crossed. The
/// branches are predicted well, and keep the loop from being vectorised: vectors would wait for numbers that
/// were stored one by one just before.
inline bool are_within(const double* numbers, const CrossingPast& past) {
  for (std::size_t i = 0; i < past.count; ++i)
    if (!((past.low[i] <= numbers[i]) & (numbers[i] <= past.high[i]))) return false;
  return true;
}

/// True if a number may have passed 0 twice within a step, with the same sign at both ends. The past then is
/// that of the next step.
///
/// It may if at both ends it is nearer to 0 than half of its bend in this or the last step. A parabola with
/// this bend dips below its ends by a quarter of that. Without a past the answer is true. In the step after
/// that it is true for numbers without a band.
///
/// A number that changes by less than an eighth of itself gets a band of that width. Its bend is not known
/// while it stays there, and is then estimated by the width.
inline bool may_cross_twice(const double* before, const double* after, CrossingPast past, double length) {
  constexpr double part = 0.125;
  const bool known = past.length > 0.0;
  const double ratio = known ? length / past.length : 1.0, scale = 2.0 * ratio / (1.0 + ratio);
  bool may = !known;
  for (std::size_t i = 0; i < past.count; ++i) {
    const double change = after[i] - before[i], width = past.high[i] - past.low[i];
    const bool banded = width >= 0.0;
    const double bend = banded ? std::abs(change) + width : scale * std::abs(change - ratio * past.change[i]);
    const double last = banded ? 2.0 * width : ratio * ratio * past.bend[i];
    may |= std::min(std::abs(before[i]), std::abs(after[i])) < 0.5 * std::max(bend, last);
    const double near = (1.0 - part) * after[i], far = (1.0 + part) * after[i];
    const bool rests = before[i] == after[i] || std::abs(change) <= part * std::abs(after[i]);
    past.low[i] = rests ? std::min(near, far) : 1.0;
    past.high[i] = rests ? std::max(near, far) : -1.0;
    past.change[i] = rests ? 0.0 : change;
    past.bend[i] = rests ? 0.0 : known ? bend : std::numeric_limits<double>::infinity();
  }
  past.length = length;
  return may;
}

/// How a step is checked for events.
struct EventCheck {
  double length;      ///< Length of the step.
  bool edge;          ///< True if a source has an edge within the step.
  bool at_tick;       ///< True if the step ends at a tick.
  bool looks;         ///< True if steps with numbers that may cross twice are examined.
  bool looks_always;  ///< True if all steps are.
  /// True if the step begins with the numbers at the end of the last one, and that was not eventful. A number
  /// that has a band is within it there.
  bool continues = false;
};

/// True if a step with numbers beyond their bands, or with an edge, must be repeated from event to event. The
/// arguments are passed in registers: a quiet step then stores nothing for this call.
[[gnu::noinline]] inline bool is_eventful_beyond_bands(const double* before, const double* after,
                                                       double* numbers, std::size_t count, EventCheck step) {
  const CrossingPast past(numbers, count);
  const bool may = may_cross_twice(before, after, past, step.length);
  return step.edge || step.looks_always || (step.looks && may) || sign_changes(before, after, count) ||
         (step.at_tick && almost_crosses(before, after, count));
}

/// True if the step must be repeated from event to event.
inline bool is_eventful(const double* before, const double* after, CrossingPast past, EventCheck step) {
  if (!step.edge && !step.looks_always && (step.continues || are_within(before, past)) &&
      are_within(after, past)) [[likely]]
    return false;
  return is_eventful_beyond_bands(before, after, &past.length, past.count, step);
}

}  // namespace stepwire::solve

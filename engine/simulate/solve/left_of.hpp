#pragma once

namespace stepwire::solve {

/// Just before a time [s], seen from a step of `length` that leads there: a source that jumps at that time,
/// as `reached()` compares it, has not done so yet. A solver cannot tell the two times apart.
inline double left_of(double time, double length) {
  constexpr double part = 1.0 / (1LL << 48);  // 16 roundings
  return time - part * (time + length);
}

}  // namespace stepwire::solve

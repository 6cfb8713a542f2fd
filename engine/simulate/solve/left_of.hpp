#pragma once

namespace stepwire::solve {

/// Returns a time [s] just before the end of a step of `length`. At this time a source that jumps at `time`,
/// as reached() compares it, has not jumped yet. The difference is below the resolution of a solver.
inline double left_of(double time, double length) {
  constexpr double part = 1.0 / (1LL << 48);  // 16 units of rounding
  return time - part * (time + length);
}

}  // namespace stepwire::solve

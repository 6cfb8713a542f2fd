#pragma once

#include <limits>

#include "blocks/math/bracket.hpp"

namespace stepwire {

/// What a table says beyond its ends: the value at the end, the straight line of its last piece, or no
/// number, which ends the run.
enum class Extrapolation { hold, linear, refuse };

/// The bracket of x with a share that follows this rule outside of the points.
inline Bracket bracket(const Numbers& points, double x, Extrapolation beyond) {
  Bracket at = bracket(points, x);
  if (at.share >= 0.0 && at.share <= 1.0) return at;
  if (beyond == Extrapolation::hold && at.share == at.share) at.share = at.share < 0.0 ? 0.0 : 1.0;
  if (beyond == Extrapolation::refuse) at.share = std::numeric_limits<double>::quiet_NaN();
  return at;
}

/// From one value to another; both ends are met exactly.
inline double between(double from, double to, double share) {
  return (1.0 - share) * from + share * to;
}

}  // namespace stepwire

#pragma once

#include <limits>

#include "blocks/math/bracket.hpp"

namespace stepwire {

/// Extrapolation of a table: the value at the end, the straight line of the last piece, or NaN, which ends
/// the run.
enum class Extrapolation { hold, linear, refuse };

/// Returns the bracket of x, with a share that follows this rule outside of the points.
inline Bracket bracket(const Numbers& points, double x, Extrapolation beyond) {
  Bracket at = bracket(points, x);
  if (at.share >= 0.0 && at.share <= 1.0) return at;
  if (beyond == Extrapolation::hold && at.share == at.share) at.share = at.share < 0.0 ? 0.0 : 1.0;
  if (beyond == Extrapolation::refuse) at.share = std::numeric_limits<double>::quiet_NaN();
  return at;
}

/// Interpolates between two values; both ends are exact.
inline double between(double from, double to, double share) {
  return (1.0 - share) * from + share * to;
}

}  // namespace stepwire

#pragma once

#include <algorithm>

#include "engine/model/signal/numbers.hpp"

namespace stepwire {

/// Position of a number among increasing points: between points[index] and the next one, at the fraction
/// `share`. Below the first point the share is negative, above the last one greater than 1.
struct Bracket {
  Index index;
  double share;
};

/// Returns the bracket of x; requires two points or more.
inline Bracket bracket(const Numbers& points, double x) {
  const double* const first = points.data();
  const double* const above = std::upper_bound(first + 1, first + points.size() - 1, x);
  const Index index = above - first - 1;
  return {index, (x - first[index]) / (first[index + 1] - first[index])};
}

}  // namespace stepwire

#include "engine/view/geometry/curve.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::geometry {

void Extent::add(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

Extent Extent::padded(double share) const {
  if (empty()) return {0.0, 1.0};
  const double least = 1e-9 * std::max(std::abs(low), std::abs(high));
  const double room =
      width() > least ? share * width() : std::max(0.05 * std::abs(low), least > 0.0 ? least : 1.0);
  return {low - room, high + room};
}

Extent extent_of(const std::vector<double>& values) {
  Extent extent;
  for (const double value : values) extent.add(value);
  return extent;
}

}  // namespace stepwire::geometry

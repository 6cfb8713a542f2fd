#pragma once

#include <limits>
#include <vector>

namespace stepwire::geometry {

/// Smallest and largest number seen.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value);
  bool empty() const { return !(low <= high); }
  double width() const { return high - low; }
  /// Widened by a share of its width on both sides; where it is one point, so that it has a width at all.
  Extent padded(double share) const;
};

/// Smallest and largest value of a column.
Extent extent_of(const std::vector<double>& values);

}  // namespace stepwire::geometry

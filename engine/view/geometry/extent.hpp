#pragma once

#include <limits>
#include <vector>

namespace stepwire::geometry {

/// Minimum and maximum of the added numbers.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value);
  bool empty() const { return !(low <= high); }
  double width() const { return high - low; }
  /// Returns the extent widened by a share of its width on both sides; a single point gets a positive width.
  Extent padded(double share) const;
};

/// Returns the minimum and maximum of a column.
Extent extent_of(const std::vector<double>& values);

}  // namespace stepwire::geometry

#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace stepwire::geometry {

/// Successive rows without a gap, in the displayed units: one column for each channel.
struct Curve {
  std::vector<std::vector<double>> columns;
  std::size_t group = 0;  ///< index into Curves::groups

  std::size_t size() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// All curves of one y of a panel, with the values that distinguish them.
struct Curves {
  std::vector<Curve> curves;
  std::vector<double> groups;        ///< Values of `by`, ascending; one element without a `by`.
  bool logarithmic = false;          ///< True if an axis of the panel is logarithmic.
  std::vector<double> shown;         ///< Width of the given range of each column; infinite without one.
  std::vector<std::string> labels;   ///< Label of each group, "0.1 A"; empty without a `by`.
  std::vector<std::string> legends;  ///< Text of each group in a legend, "current = 0.1 A"; empty likewise.
  bool several = false;              ///< True if the panel has curves of further y's.
};

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

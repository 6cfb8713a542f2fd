#pragma once

#include <cstddef>
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
  std::vector<double> groups;       ///< Values of `by`, ascending; one element without a `by`.
  bool logarithmic = false;         ///< True if an axis of the panel is logarithmic.
  std::vector<double> shown;        ///< Width of the given range of each column; infinite without one.
  std::vector<std::string> labels;  ///< Label of each group, "0.1 A"; empty without a `by`.
  bool several = false;             ///< True if the panel has curves of further y's.
};

}  // namespace stepwire::geometry

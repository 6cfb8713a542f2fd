#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stepwire::geometry {

/// Rows that follow each other without a gap, in the units in which they are drawn: one column for each
/// channel.
struct Curve {
  std::vector<std::vector<double>> columns;
  std::size_t group = 0;  ///< index into Curves::groups

  std::size_t size() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// All curves of one y of a panel, and what tells them apart.
struct Curves {
  std::vector<Curve> curves;
  std::vector<double> groups;  ///< values of `by`, ascending; one element where there is none
  bool logarithmic = false;    ///< on an axis of the panel, so that straight lines are not straight
  std::vector<double> shown;   ///< width of the range that the file gives for each column; infinite if none
  std::vector<std::string> labels;  ///< "0.1 A", one for each group; empty where there is no `by`
  bool several = false;             ///< curves of further y's are drawn beside these
};

}  // namespace stepwire::geometry

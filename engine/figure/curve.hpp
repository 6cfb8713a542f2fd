#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/figure/figure.hpp"

namespace stepwire {

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

/// Rows of a recording as curves. A curve ends where a run ends, where a row is left out by `where` or is not
/// finite, and where the value of `by` changes. With `rows: final` each run gives one row, and the runs are
/// joined.
Curves gather(const Panel& panel, const Recording& recording, const std::vector<const Series*>& channels);

/// The same for columns of numbers, the first along x and the others along y, of a plot that no file gives.
Curves curves_of(const Panel& panel, std::vector<std::vector<double>> columns);

/// "0.1 A" for each value of a series that tells curves apart, or the word that the value stands for.
std::vector<std::string> labels_of(const Series& by, const std::vector<double>& groups,
                                   const Recording& recording);

}  // namespace stepwire

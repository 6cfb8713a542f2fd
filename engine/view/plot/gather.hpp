#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/view/geometry/curve.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// Rows of a recording as curves. A curve ends where a run ends, where a row is left out by `where` or is not
/// finite, and where the value of `by` changes. With `rows: final` each run gives one row, and the runs are
/// joined.
geometry::Curves gather(const Panel& panel, const record::Recording& recording,
                        const std::vector<const query::Series*>& channels);

/// The same for columns of numbers, the first along x and the others along y, of a plot that no file gives.
geometry::Curves curves_of(const Panel& panel, std::vector<std::vector<double>> columns);

/// "0.1 A" for each value of a series that tells curves apart, or the word that the value stands for.
std::vector<std::string> labels_of(const query::Series& by, const std::vector<double>& groups,
                                   const record::Recording& recording);

}  // namespace stepwire::plot

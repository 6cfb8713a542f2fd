#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/view/geometry/curve.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// Returns rows of a recording as curves. A curve ends at the end of a run, at a row that `where` excludes or
/// that is not finite, and at a change of `by`. With `rows: final` each run has one row, and the runs are
/// joined.
geometry::Curves gather(const Panel& panel, const record::Recording& recording,
                        const std::vector<const query::Series*>& channels);

/// Returns the same for columns of numbers, the first along x and the others along y, of a plot that is not
/// from a file.
geometry::Curves curves_of(const Panel& panel, std::vector<std::vector<double>> columns);

/// Returns the label of each value of `by`, "0.1 A", or the word that the value is an index of. With `named`
/// numbers have the name of what they are values of: "current = 0.1 A".
std::vector<std::string> labels_of(const query::Series& by, const std::vector<double>& groups,
                                   const record::Recording& recording, bool named = false);

/// Sets the unit of a swept parameter in a legend to that of its numbers in the file.
void show_as_written(query::Series& swept, const query::SymbolTable& names);

}  // namespace stepwire::plot

#pragma once

#include <cstddef>
#include <span>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// Rows of the runs of a sweep that a panel reads.
enum class RowsRead { none, last, all };

/// `recordings` is the number of recordings of runs; others, such as those of linear analyses, follow them.
RowsRead rows_read(const Panel& panel, std::size_t recordings);

/// Returns the first row of a recording of one run that a panel that reads last rows may draw. It is the last
/// row with values for everything drawn, or the first row without such a row. Returns the number of rows if
/// the panel draws none.
std::size_t first_drawn_row(const Panel& panel, std::span<const record::Recording> run,
                            std::size_t recording);

}  // namespace stepwire::plot

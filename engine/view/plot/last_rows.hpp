#pragma once

#include <cstddef>
#include <span>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// Which rows of the runs of a sweep a panel reads.
enum class RowsRead { none, last, all };

/// `recordings` is the number of those that runs make; others, as of linear analyses, lie behind them.
RowsRead rows_read(const Panel& panel, std::size_t recordings);

/// The first row of a recording of one run that a panel may draw which reads last rows: the last one in which
/// all that it shows has a value, or the first one where none has. The number of rows where it draws none.
std::size_t first_drawn_row(const Panel& panel, std::span<const record::Recording> run,
                            std::size_t recording);

}  // namespace stepwire::plot

#pragma once

#include <optional>
#include <span>
#include <string>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// True for an expression of a channel that reduces the rows of a run, such as `max(x)`.
bool reduces_runs(const yaml::Node& node);

/// Reads such an expression, with its unit and label, in the syntax of claims. Adds its number of each run to
/// the panel; the series reads that number.
std::optional<query::Series> read_run_series(const yaml::Node& node, const query::NamesReading& read,
                                             Panel& panel);

/// Returns a row for each run with a row that `where` of the panel selects: its end time, swept parameters,
/// and the numbers of the panel.
record::Recording numbers_of_runs(const Panel& panel, std::span<const record::Recording> recordings);

}  // namespace stepwire::plot

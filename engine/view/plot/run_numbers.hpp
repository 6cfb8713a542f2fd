#pragma once

#include <optional>
#include <span>
#include <string>

#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// True for an expression of a channel that reduces the rows of a run, as `max(x)` does.
bool reduces_runs(const yaml::Node& node);

/// Reads such an expression, with its unit and label, as claims read it; its number of each run is added to
/// the panel, and is what the series reads.
std::optional<query::Series> read_run_series(const yaml::Node& node, const query::NamesReading& read,
                                             Panel& panel);

/// A row for each run of which `where` of the panel selects a row: its end time, what is swept, and the
/// numbers of the panel.
record::Recording numbers_of_runs(const Panel& panel, std::span<const record::Recording> recordings);

}  // namespace stepwire::plot

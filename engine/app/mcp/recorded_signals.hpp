#pragma once

#include <cstddef>
#include <string>

#include "engine/base/json/json.hpp"

namespace stepwire::mcp {

/// Returns the table of a CSV file that `run --csv` wrote: `columns` with units, `rows` with at most `most`
/// evenly chosen ones, and `of`, the number of all rows. Numbers that are not finite are null. Throws
/// TableError and EnvironmentError.
json::Json recorded_signals(const std::string& file, std::size_t most);

}  // namespace stepwire::mcp

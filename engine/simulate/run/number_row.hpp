#pragma once

#include <span>

#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::run {

/// The row of the numbers that are kept of a run, behind its last time: of what it recorded, its swept
/// parameters as columns.
record::Recording number_row(const RunNumbers& numbers, std::span<const record::Recording> run);

}  // namespace stepwire::run

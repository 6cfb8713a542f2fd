#pragma once

#include <span>

#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::run {

/// Computes the row of numbers that a sweep keeps of a run, with the last time in front. The recording of the
/// run has its swept parameters as columns.
record::Recording number_row(const RunNumbers& numbers, std::span<const record::Recording> run);

}  // namespace stepwire::run

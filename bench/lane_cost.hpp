#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// Measures the time of a run's step in a lane batch, and its ratio to that of generated code for one run.
/// Both record rows and check for non-finite numbers. Returns an empty list if there are no lanes.
std::vector<Result> measure_lanes();

}  // namespace stepwire

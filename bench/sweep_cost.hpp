#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// A sweep of 100,000 compiled runs of cart.yaml against one long run of the same ticks: the time of a tick,
/// what a point costs beside its ticks, the memory beyond the rows, and how much of the time is left with
/// twice the threads. None where there is no compiler.
std::vector<Result> measure_sweep();

}  // namespace stepwire

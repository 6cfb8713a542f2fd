#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// Times one step of every workload by every method in random order, with the options of Google Benchmark.
/// Returns the processor time, one result per repetition.
std::vector<Result> measure_steps();

}  // namespace stepwire

#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// Times one step of every workload by every means, all in turn, with the options that Google Benchmark was
/// given: processor time, one result for each repetition.
std::vector<Result> measure_steps();

}  // namespace stepwire

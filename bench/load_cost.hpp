#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// Processor time from the text of W2 to its first step, several times, and the peak memory of the process
/// after the first of them. That peak is of all that the process did before, so this comes first.
std::vector<Result> measure_load(int blocks, int times);

}  // namespace stepwire

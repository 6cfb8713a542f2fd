#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// Measures the processor time from the text of W2 to its first step, several times. The peak memory of the
/// process is read after the first time. That peak includes all earlier work, so this benchmark must be the
/// first.
std::vector<Result> measure_load(int blocks, int times);

}  // namespace stepwire

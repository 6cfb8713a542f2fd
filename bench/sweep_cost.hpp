#pragma once

#include <string>
#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// Measures a sweep of 100,000 compiled runs of cart.yaml, and one of 10,000 of W1. Each is compared with one
/// long run of the same ticks. Results are the time of a tick, the other cost of a point, and the memory
/// without rows. A further result is the ratio of times with twice the threads. Empty without a compiler.
std::vector<Result> measure_sweeps();

/// Returns the peak memory of this process during the sweep of a file, minus the memory before it and that of
/// its rows [MB]. Runs last 1 s.
double sweep_memory(const std::string& file);
/// Option of this program that prints sweep_memory() only.
inline constexpr const char* sweep_memory_option = "--sweep-memory";

/// Measures the time of a sweep of W1 over that of its steps alone. It has 256 compiled runs of 10 s, 8
/// signals recorded at every tick, and two threads. Empty without a compiler.
std::vector<Result> measure_w1_sweep();

}  // namespace stepwire

#pragma once

#include <string>
#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// A sweep of 100,000 compiled runs of cart.yaml, and one of 10,000 of W1, each against one long run of the
/// same ticks: the time of a tick, what a point costs beside its ticks, the memory beyond the rows, and how
/// much of the time is left with twice the threads. None where there is no compiler.
std::vector<Result> measure_sweeps();

/// How far the peak of this process' memory lies above what it has before the sweep of a file, in runs of 1
/// s, and the rows of it [MB].
double sweep_memory(const std::string& file);
/// The option by which this program prints sweep_memory() alone.
inline constexpr const char* sweep_memory_option = "--sweep-memory";

/// The time of a sweep of W1 over that of its steps alone: 256 compiled runs of 10 s, 8 signals recorded at
/// every tick, two threads. None where there is no compiler.
std::vector<Result> measure_w1_sweep();

}  // namespace stepwire

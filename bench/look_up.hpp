#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// Measures the processor time to find the nearest boundary point of a corridor of 100 points, along straight
/// lines and along a spline. The places are random, up to 20 mm beside it. Repeats this several times.
std::vector<Result> measure_look_up(int times);

}  // namespace stepwire

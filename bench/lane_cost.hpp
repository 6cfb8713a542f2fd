#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// What a step of a run costs that is stepped together with others, over that of generated code for one run:
/// both with rows recorded and the look for numbers that are not finite. Nothing where there are no lanes.
std::vector<Result> measure_lanes();

}  // namespace stepwire

#pragma once

#include <vector>

#include "bench/result.hpp"

namespace stepwire {

/// Measures the steps of a diagram in which nothing crosses, with `events: locate` over `events: tick`.
std::vector<Result> measure_events();

}  // namespace stepwire

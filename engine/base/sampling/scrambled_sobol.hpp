#pragma once

#include "engine/base/sampling/design.hpp"

namespace stepwire::sampling {

/// Fills points with those of Sobol from the first one on, scrambled by a seed.
void lay_out_sobol(Points& points, std::int64_t seed);

}  // namespace stepwire::sampling

#pragma once

#include "engine/base/sampling/design.hpp"

namespace stepwire::sampling {

/// Fills points with the Sobol sequence from its first point on, scrambled by a seed.
void lay_out_sobol(Points& points, std::int64_t seed);

}  // namespace stepwire::sampling

#pragma once

#include <vector>

#include "engine/app/fmu/variables.hpp"

namespace stepwire::fmu {

/// Splits array variables into scalars, because FMI 2 has no arrays: "x[2]", "m[1,3]", "der(x[2])". Event
/// indicators are dropped, since they are no variables in FMI 2.
std::vector<Variable> scalars_of(const std::vector<Variable>& variables);

}  // namespace stepwire::fmu

#pragma once

#include <vector>

#include "engine/app/fmu/variables.hpp"

namespace stepwire::fmu {

/// The same variables with one for each number, as FMI 2 has them: "x[2]", "m[1,3]", "der(x[2])". Event
/// indicators are none there.
std::vector<Variable> scalars_of(const std::vector<Variable>& variables);

}  // namespace stepwire::fmu

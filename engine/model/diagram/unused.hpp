#pragma once

#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Reports parameters of a file and of its parts that nothing uses: no value, expression, part, figure, claim
/// or sweep. Changing one would change nothing, so it is a slip of the hand or a remainder.
void refuse_unused_parameters(const Scope& scope, Report& report);

}  // namespace stepwire::diagram

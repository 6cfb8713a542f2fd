#pragma once

#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Reports unused parameters of a file and its parts: no value, expression, part, figure, claim or sweep
/// refers to them. A change of such a parameter would have no effect, so it is a mistake or a remainder.
void refuse_unused_parameters(const Scope& scope, Report& report);

}  // namespace stepwire::diagram

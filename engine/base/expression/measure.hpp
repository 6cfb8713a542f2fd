#pragma once

#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/base/expression/program.hpp"

namespace stepwire::expression {

/// Infers the unit of an expression from those of its variables. Throws ExpressionError, with the place in
/// the text, where units that are sure are incompatible: "x + t" of metres and seconds.
Measure measure_of(const Program& program, const std::vector<Measure>& variables);

}  // namespace stepwire::expression

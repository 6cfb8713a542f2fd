#pragma once

#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/base/expression/program.hpp"

namespace stepwire::expression {

/// The unit of an expression's value, from those of its variables. Throws ExpressionError, with the place in
/// the text, where units that are sure do not fit: "x + t" of metres and seconds.
Measure measure_of(const Program& program, const std::vector<Measure>& variables);

}  // namespace stepwire::expression

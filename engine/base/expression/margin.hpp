#pragma once

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

/// A number that changes its sign where a condition begins or ceases to hold: of "x > 3 mm && !(y < 2)" the
/// smaller of x - 0.003 and y - 2, of what is no comparison its value. It has the same variables, in the same
/// order.
Expression margin_of(const Expression& condition);

}  // namespace stepwire::expression

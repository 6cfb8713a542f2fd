#pragma once

#include <vector>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

/// A number that changes its sign where a condition begins or ceases to hold: of "x > 3 mm && !(y < 2)" the
/// smaller of x - 0.003 and y - 2, of what is no comparison its value. It has the same variables, in the same
/// order.
Expression margin_of(const Expression& condition);

/// Where a formula begins to compute something else.
struct Branches {
  bool truth = false;               ///< Its value is a truth: it is constant in between.
  std::vector<Expression> margins;  ///< of its conditions
};
Branches branches_of(const Expression& formula);

}  // namespace stepwire::expression

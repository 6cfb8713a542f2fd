#pragma once

#include <vector>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

/// Returns a number that changes its sign where a condition begins or ceases to hold. Of "x > 3 mm && !(y <
/// 2)" it is the smaller of x - 0.003 and y - 2, of a number its value. The variables are the same, in the
/// same order.
Expression margin_of(const Expression& condition);

/// Places at which a formula begins to compute something else: its conditions, and the jumps and bends of
/// abs, sign, floor, ceil, round, min, max and mod.
struct Branches {
  bool steady = false;              ///< The value is constant between sign changes of the margins.
  std::vector<Expression> margins;  ///< Each changes its sign at such a place; jumps come first; at most 16.
};
Branches branches_of(const Expression& formula);

}  // namespace stepwire::expression

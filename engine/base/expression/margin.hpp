#pragma once

#include <vector>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

/// Returns an expression that changes sign where a condition changes its truth, for zero-crossing detection.
/// For "x > 3 mm && !(y < 2)" it is the smaller of x - 0.003 and y - 2; for a number it is the number. The
/// variables are the same, in the same order.
Expression margin_of(const Expression& condition);

/// Branch points of a formula: its conditions, and the jumps and bends of abs, sign, floor, ceil, round, min,
/// max and mod.
struct Branches {
  bool steady = false;              ///< True where the value is constant between sign changes of the margins.
  std::vector<Expression> margins;  ///< Change sign at a branch point; jumps first; at most 16.
};
Branches branches_of(const Expression& formula);

}  // namespace stepwire::expression

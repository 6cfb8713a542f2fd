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
  std::vector<std::string>
      texts;  ///< Of each margin: the condition, or the value that jumps; empty for a bend.
};
Branches branches_of(const Expression& formula);

/// A formula whose jumps are held. Its variables are those of the formula, and one for each mode.
struct Held {
  Expression formula;
  std::vector<Expression> modes;   ///< Over the variables of the formula; constant between two jumps.
  std::vector<std::string> names;  ///< Variables of the modes in the held formula.
};
/// Returns a formula that is smooth at its jumps while the modes stay the same, and has the value of the
/// given one with the modes of the present values. It holds the jumps among the first `most` margins of
/// branches_of().
Held held_of(const Expression& formula, std::size_t most);

}  // namespace stepwire::expression

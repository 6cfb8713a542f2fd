#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/expression/operation.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::expression {

inline constexpr std::size_t longest_text = 5000;

/// One part of an evaluation, which replaces the last `count` values by one. A choice has its condition, a
/// branch, one value, a jump, and the other value before it; these two replace nothing. Arithmetic has kinds
/// of its own, since a call takes longer than it does.
struct Instruction {
  enum class Kind { variable, number, sum, difference, product, quotient, operation, branch, jump, choice };
  Kind kind;
  int count = 0;
  /// Of a variable or a number which one; of an operation its place in the text; of others the instruction
  /// behind which the evaluation goes on: after a branch only if the condition, which it removes, is 0.
  std::size_t index = 0;
  const Operation* operation = nullptr;  ///< of arithmetic as well
};

/// An expression that has been checked.
struct Program {
  struct Number {
    double value;
    std::optional<unit::Dimension> dimension;  ///< where it carries a unit
  };
  /// A variable in the text: which one, and at which character.
  struct Use {
    std::size_t variable, position;
  };
  std::string text;
  std::vector<Instruction> code;
  std::vector<Number> numbers;
  std::vector<std::string> variables;
  std::vector<Use> uses;  ///< in the order of the text
};

/// May a text have brackets and functions of matrices?
enum class Values { numbers, matrices };

/// Checks a text. Throws ExpressionError.
Program translate(std::string_view text, const std::function<bool(std::string_view)>& known,
                  Values values = Values::numbers);

}  // namespace stepwire::expression

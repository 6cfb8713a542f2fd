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

/// One instruction of the stack machine; it replaces the last `count` values by one. A choice is laid out as
/// condition, branch, first value, jump, second value, choice. The branch and the jump replace nothing.
/// Arithmetic has kinds of its own, since a call is slower.
struct Instruction {
  enum class Kind {
    variable,
    number,
    sum,
    difference,
    product,
    quotient,
    operation,
    branch,
    jump,
    choice,
    strict_branch  ///< a branch whose choice is nan where its condition is nan
  };
  Kind kind;
  int count = 0;
  /// Operand: of a variable or number its index, of an operation its position in the text. Of a branch or
  /// jump it is the target, after which the evaluation continues. A branch jumps only if the condition, which
  /// it removes, is 0.
  std::size_t index = 0;
  const Operation* operation = nullptr;  ///< set for arithmetic as well
};

/// A checked and compiled expression.
struct Program {
  struct Number {
    double value;
    std::optional<unit::Dimension> dimension;  ///< set where the number carries a unit
    bool has_offset = false;                   ///< true for a number in degC or degF
  };
  /// A use of a variable in the text: its index and character position.
  struct Use {
    std::size_t variable, position;
  };
  std::string text;
  std::vector<Instruction> code;
  std::vector<Number> numbers;
  std::vector<std::string> variables;
  std::vector<Use> uses;  ///< in the order of the text
};

/// Kind of values of the language; `matrices` allows brackets and matrix functions.
enum class Values { numbers, matrices };

/// Parses and compiles a text. A constant with hides(name) is a variable. Throws ExpressionError.
Program translate(std::string_view text, const std::function<bool(std::string_view)>& known,
                  Values values = Values::numbers,
                  const std::function<bool(std::string_view)>& hides = nullptr);

}  // namespace stepwire::expression

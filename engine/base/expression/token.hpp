#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/unit/unit.hpp"

namespace stepwire::expression {

/// A token of an expression. The value of a number is SI where it carries a unit.
struct Token {
  enum class Kind { number, name, sign, end };
  Kind kind = Kind::end;
  std::string_view text;
  std::size_t position = 0;
  double value = 0.0;
  std::optional<unit::Dimension> dimension{};  ///< of a number that carries a unit
  bool has_offset = false;                     ///< true for a number in degC or degF

  bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
};

/// Splits a text into tokens; the last one has kind `end`. After an operator inside a unit, a `known` word is
/// a name: "4 A/m" is 4 A over m where m is known. Throws ExpressionError.
std::vector<Token> tokens(std::string_view text, const std::function<bool(std::string_view)>& known);

}  // namespace stepwire::expression

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/unit/unit.hpp"

namespace stepwire {

/// An expression that has been checked, rewritten for the parser library: variable i is called "v<i>" and
/// number i "c<i>", so that no name collides with a function and no number passes through a locale.
struct Program {
  std::string code;
  std::vector<double> numbers;
  std::vector<std::optional<Dimension>> dimensions;  ///< of each number that carries a unit
  std::vector<std::string> variables;
  /// A variable in the text: which one, and at which character.
  struct Use {
    std::size_t variable, position;
  };
  std::vector<Use> uses;            ///< in the order of the text
  std::vector<std::size_t> places;  ///< in the text of each operator between two values and of each function
};

/// Checks a text and rewrites it. Throws ExpressionError.
Program translate(std::string_view text, const std::function<bool(std::string_view)>& known);

}  // namespace stepwire

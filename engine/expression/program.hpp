#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stepwire {

/// An expression that has been checked, rewritten for the parser library: variable i is called "v<i>" and
/// number i "c<i>", so that no name collides with a function and no number passes through a locale.
struct Program {
  std::string code;
  std::vector<double> numbers;
  std::vector<std::string> variables;
  /// A variable in the text: which one, and at which character.
  struct Use {
    std::size_t variable, position;
  };
  std::vector<Use> uses;   ///< in the order of the text
  bool has_units = false;  ///< does a number carry one?
};

/// Checks a text and rewrites it. Throws ExpressionError.
Program translate(std::string_view text, const std::function<bool(std::string_view)>& known);

}  // namespace stepwire

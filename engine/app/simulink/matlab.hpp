#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/app/simulink/value.hpp"

namespace stepwire::simulink {

/// Function that returns the value of a variable; a missing one has `is_missing`, or throws ValueError. With
/// `is_function` the name is that of a function, too, unless a variable hides it.
using Variables = std::function<Value(const std::string& name, bool is_function)>;

/// Evaluates a MATLAB expression of real constants: numbers, variables, + - * / ^ and their elementwise
/// forms,
/// ', [1 2; 3 4], 1:2:9, and functions such as sin, zeros, eye, linspace. Throws ValueError for other texts.
Value evaluated(std::string_view text, const Variables& variables);

/// An assignment of a script: name = expression.
struct Assignment {
  std::string name, expression;
};

/// Returns the assignments of a script of plain lines; `others` gets the statements of other forms.
std::vector<Assignment> assignments_of(const std::string& script, std::vector<std::string>& others);

}  // namespace stepwire::simulink

#pragma once

#include <string>

#include "engine/base/expression/expression.hpp"
#include "engine/base/expression/program.hpp"

namespace stepwire::expression {

/// Translates a checked expression into a C++ expression of type double or bool. Its value has the bits of
/// the interpreted evaluation, but for the sign of a NaN. Its precedence is that of ?:. It needs language.hpp
/// and namespace stepwire. The compiler must not contract products and sums. Constant folding of rounding
/// <cmath> functions must be off as well (-fno-builtin-sin, ...), since compilers round them differently.
std::string cpp_text(const Program& program, const VariableText& variable);

/// Translates an expression into a C++ condition of type bool: its value is not 0.
std::string cpp_condition_text(const Program& program, const VariableText& variable);

}  // namespace stepwire::expression

#pragma once

#include <string>

#include "engine/base/expression/expression.hpp"
#include "engine/base/expression/program.hpp"

namespace stepwire::expression {

/// A checked expression as one of C++, whose value has the bits that an evaluation gives; only the sign of a
/// nan may differ. It is a double or a bool, binds as weakly as ?: does, and stands in namespace
/// stepwire with language.hpp before it. It is to be compiled without contraction of products and sums, and
/// without knowledge of those functions of <cmath> that round (-fno-builtin-sin, ...), which a compiler
/// rounds in its own way for constants.
std::string cpp_text(const Program& program, const VariableText& variable);

/// Whether that is not 0: a bool.
std::string cpp_condition_text(const Program& program, const VariableText& variable);

}  // namespace stepwire::expression

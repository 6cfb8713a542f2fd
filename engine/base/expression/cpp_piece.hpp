#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/expression/operation.hpp"

namespace stepwire::expression {

/// A C++ subexpression and its precedence.
struct CppPiece {
  std::string text;
  Binding binding = Binding::atom;
  bool truth = false;  ///< a bool, which must not enter arithmetic: C++ would divide whole numbers
};

CppPiece cpp_number(double value);
/// Returns the C++ condition that a piece is not 0.
CppPiece cpp_truth(const CppPiece& piece);
CppPiece cpp_operation(const Operation& operation, const std::vector<CppPiece>& values);
CppPiece cpp_choice(const CppPiece& condition, const CppPiece& a, const CppPiece& b);

}  // namespace stepwire::expression

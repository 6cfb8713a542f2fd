#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stepwire::expression {

/// Precedence of the operators, weakest first. It equals that of C++, where a power is a call.
enum class Binding { open, condition, either, both, comparison, sum, product, prefix, power, atom };

/// An operator, or a function, whose precedence is that of an atom.
struct Operation {
  std::string_view name;
  Binding binding;
  int least, most;                                   ///< bounds of the number of operands
  double (*value)(const double* values, int count);  ///< nullptr for functions of matrices only

  /// True where it draws a number by a seed and a stream, its first two operands.
  bool draws() const { return name == "uniform" || name == "normal" || name == "lognormal"; }
};

extern const Operation minus, negation;  ///< prefix signs

/// Returns the binary operator or the function of that name; nullptr if there is none.
const Operation* find_operator(std::string_view sign);
const Operation* find_function(std::string_view name);
/// Returns the names of all functions of numbers.
std::vector<std::string> function_names();
/// Returns the matrix function of that name; nullptr if there is none.
const Operation* find_matrix_function(std::string_view name);
/// Returns the same operation for values of which some are not defined (nan): no comparison, truth, least or
/// greatest of such a value is defined, unless the other operand of && or || decides.
const Operation* strict(const Operation* operation);
extern const Operation brackets;  ///< [a, b, ..]

}  // namespace stepwire::expression

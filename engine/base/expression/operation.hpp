#pragma once

#include <string_view>

namespace stepwire::expression {

/// How strongly the operators of the language bind, which is how those of C++ do; a power is a call there.
enum class Binding { open, condition, either, both, comparison, sum, product, prefix, power, atom };

/// What makes one value of others: an operator, or a function, which binds as an atom does.
struct Operation {
  std::string_view name;
  Binding binding;
  int least, most;                                   ///< how many values it takes
  double (*value)(const double* values, int count);  ///< null of what only matrices have

  /// Whether it draws a number by a seed and a stream, its first two values.
  bool draws() const { return name == "uniform" || name == "normal" || name == "lognormal"; }
};

extern const Operation minus, negation;  ///< the signs before a value

/// The operator between two values, or the function, of that name; nullptr if there is none.
const Operation* find_operator(std::string_view sign);
const Operation* find_function(std::string_view name);
/// The function of matrices of that name; nullptr if there is none.
const Operation* find_matrix_function(std::string_view name);
extern const Operation brackets;  ///< [a, b, ..]

}  // namespace stepwire::expression

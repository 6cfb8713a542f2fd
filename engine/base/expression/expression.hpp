#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/unit/unit.hpp"

namespace stepwire::expression {

/// Thrown for an invalid expression; `position` counts characters of the text from 0.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& message, std::size_t at) : std::runtime_error(message), position(at) {}
  std::size_t position;
};

/// Inferred unit of a value. A bare number is assumed to be in the SI unit of its partner in a sum or
/// comparison.
struct Measure {
  std::optional<unit::Dimension> dimension;  ///< std::nullopt where the dimension is unknown
  bool sure = false;                         ///< no factor is a bare number, which could have any unit
};

/// Function that returns the C++ text of variable i of an expression.
using VariableText = std::function<std::string(std::size_t i)>;

struct Program;

/// Returns the text "v[i]" of variable i.
std::string element_of_v(std::size_t i);

/// A scalar formula over named numbers; the common language of parameters, figures, claims and blocks.
///
/// Operators are + - * / ^ ( ) < <= > >= == != && || ! and cond ? a : b. Powers are right-associative and
/// bind stronger than a sign: -2^2 is -4. Functions are sin cos tan asin acos atan atan2 sinh cosh tanh exp
/// log (natural) log10 log2 sqrt cbrt abs sign floor ceil hypot. Further ones are round (halves away from 0),
/// min and max (of two or more) and mod (sign of the divisor). Draws from whole numbers are uniform(seed,
/// stream) and lognormal(seed, stream, variation); see language.hpp. Constants are pi and e.
///
/// A number may carry a unit and is then SI: "x > -4 mm", "2*pi*3 kHz". A name directly after a number is its
/// unit; variables follow an operator, so a variable may be called "m" or "N". Thus "4 N * N" is 4 newtons
/// times the variable N. Names may contain dots and an index: "rig.x", "rig.x[2]". Copies share the parsed
/// program, and any number of threads may evaluate one object.
class Expression {
 public:
  /// Parses a text. Throws ExpressionError for an invalid one. All names but pi and e become variables.
  explicit Expression(std::string_view text);
  /// Parses a text in which only names with known(name) are valid; an unknown name throws with its position.
  /// A known "pi" or "e" hides the constant, and "4 A/m" is 4 amperes over m where m is known.
  Expression(std::string_view text, const std::function<bool(std::string_view)>& known);

  /// Parses a text in which all names become variables, as also does a constant ("pi", "e") with hides(name).
  /// Throws ExpressionError for an invalid text.
  static Expression hiding_constants(std::string_view text,
                                     const std::function<bool(std::string_view)>& hides);

  /// Returns the same formula for numbers that may be missing: a comparison, truth, choice, least or greatest
  /// of nan is nan, unless the other operand of && or || decides.
  Expression strict() const;

  const std::string& text() const;
  /// Returns the names used, in order of first appearance.
  const std::vector<std::string>& variables() const;
  /// Returns the text with its variables renamed, one new name for each.
  std::string renamed(const std::vector<std::string>& names) const;
  /// Infers the unit of the value from those of the variables. Throws ExpressionError for incompatible units.
  Measure measure(const std::vector<Measure>& variables) const;
  /// Throws ExpressionError, with its place, where a number is drawn by a seed or stream that is not whole.
  /// `values` are those of the variables in order. Draws that depend on an unknown value are not checked.
  void check_draws(std::span<const std::optional<double>> values) const;
  /// Evaluates the expression with one value for each variable, in order. Neither allocates nor throws.
  /// Division by zero gives infinity or NaN, as in IEEE 754.
  double operator()(std::span<const double> values) const;
  /// Evaluates it where the value of variable i is numbers[places[i]].
  double operator()(const double* numbers, std::span<const std::size_t> places) const;
  /// Returns a C++ expression of its value, a double or a bool, with the bits of the interpreted evaluation
  /// but for the sign of a NaN. Its precedence is that of ?:. It needs language.hpp and namespace stepwire.
  /// The compiler must neither contract products and sums nor fold constant calls of <cmath>
  /// (-fno-builtin-sin, ...).
  std::string cpp(const VariableText& variable = element_of_v) const;
  /// Returns a C++ expression of type bool: the value is not 0.
  std::string cpp_condition(const VariableText& variable = element_of_v) const;

 private:
  std::shared_ptr<const Program> program_;
};

}  // namespace stepwire::expression

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

/// What is wrong with an expression, and where: `position` counts characters of the text from 0.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& message, std::size_t at) : std::runtime_error(message), position(at) {}
  std::size_t position;
};

/// What is known of the unit of a value. A bare number is SI of whatever it meets in a sum or a comparison.
struct Measure {
  std::optional<unit::Dimension> dimension;  ///< none where it is not known
  bool sure = false;                         ///< no bare number is a factor of it, which could be in any unit
};

/// How C++ gets at variable i of an expression.
using VariableText = std::function<std::string(std::size_t i)>;

struct Program;

/// "v[i]"
std::string element_of_v(std::size_t i);

/// A scalar formula over named numbers, the one language of parameters, figures, claims and blocks.
/// Operators + - * / ^ ( ) < <= > >= == != && || ! and cond ? a : b; functions sin cos tan asin acos atan
/// atan2 sinh cosh tanh exp log (natural) log10 log2 sqrt cbrt abs sign floor ceil round (halves away from 0)
/// min max (of two or more) mod (sign of the divisor) hypot, uniform(seed, stream) and lognormal(seed,
/// stream, variation) (numbers drawn from whole numbers, language.hpp); constants pi, e. ^ binds right and
/// before a sign: -2^2 is -4. A number may carry a unit and is SI then: "x > -4 mm", "2*pi*3 kHz". What
/// directly follows a number can only be its unit; names have an operator before them, so a variable may be
/// called "m" or "N": "4 N * N" is 4 newtons times N. Names may contain dots and an index: "rig.x",
/// "rig.x[2]". Copies share what was read, and any number of threads may evaluate one object.
class Expression {
 public:
  /// Throws ExpressionError for a text that cannot be read; variables are whatever names it uses, except pi
  /// and e.
  explicit Expression(std::string_view text);
  /// `known(name)` says whether a name exists: an unknown name is an error with its position, a known "pi" or
  /// "e" is no constant, and "4 A/m" is 4 amperes over m where m is known.
  Expression(std::string_view text, const std::function<bool(std::string_view)>& known);

  const std::string& text() const;
  /// Names used, in order of first appearance.
  const std::vector<std::string>& variables() const;
  /// The text with its variables called otherwise, one name for each.
  std::string renamed(const std::vector<std::string>& names) const;
  /// The unit of its value, from those of its variables; throws ExpressionError where they do not fit each
  /// other.
  Measure measure(const std::vector<Measure>& variables) const;
  /// Throws ExpressionError, with its place, where a number is drawn by a seed or a stream that is not whole.
  /// Variables are in their order; what hangs on one that is not known is passed over.
  void check_draws(std::span<const std::optional<double>> values) const;
  /// Value with the variables in that order, one for each. Allocates nothing and throws nothing. Division by
  /// zero gives inf or nan, as IEEE says.
  double operator()(std::span<const double> values) const;
  /// The same where variable i is numbers[places[i]].
  double operator()(const double* numbers, std::span<const std::size_t> places) const;
  /// Its value as an expression of C++: a double or a bool. See cpp_text.hpp.
  std::string cpp(const VariableText& variable = element_of_v) const;
  /// Whether it is not 0, as an expression of C++: a bool.
  std::string cpp_condition(const VariableText& variable = element_of_v) const;

 private:
  std::shared_ptr<const Program> program_;
};

}  // namespace stepwire::expression

#include "engine/base/expression/margin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/expression/fold.hpp"

namespace stepwire::expression {
namespace {

/// A part of a condition: its value as text, and its margin.
struct Part {
  std::string value, margin;
  bool truth = false;

  /// Of a number that stands where a truth is meant, which it is unless it is 0.
  std::string as_truth() const { return truth ? margin : "abs(" + value + ")"; }
};

std::string joined(const std::vector<Part>& parts) {
  std::string list;
  for (const Part& part : parts) list += (list.empty() ? "" : ", ") + part.value;
  return list;
}

struct MakeMargin {
  const std::vector<std::string>& variables;

  Part variable(std::size_t i) const { return {variables[i], variables[i]}; }
  Part number(const Program::Number& number) const {
    const std::string text = fmt::format("({:.17g})", number.value);
    return {text, text};
  }
  Part operation(const Operation& operation, const std::vector<Part>& of, std::size_t) const {
    if (operation.binding == Binding::prefix) return prefix(operation.name, of[0]);
    if (operation.binding == Binding::atom) {
      const std::string text = fmt::format("{}({})", operation.name, joined(of));
      return {text, text};
    }
    const std::string text = fmt::format("({} {} {})", of[0].value, operation.name, of[1].value);
    if (operation.binding == Binding::comparison)
      return {text, comparison(operation.name, of[0].value, of[1].value), true};
    if (operation.binding < Binding::comparison)
      return {text,
              fmt::format("{}({}, {})", operation.binding == Binding::both ? "min" : "max", of[0].as_truth(),
                          of[1].as_truth()),
              true};
    return {text, text};
  }
  Part choice(const Part& condition, const Part& a, const Part& b) const {
    const auto text = [&](const std::string& first, const std::string& second) {
      return fmt::format("({} ? {} : {})", condition.value, first, second);
    };
    return {text(a.value, b.value), text(a.margin, b.margin), a.truth && b.truth};
  }

 private:
  static Part prefix(std::string_view sign, const Part& of) {
    const std::string text = fmt::format("({}{})", sign, of.value);
    if (sign == "!") return {text, fmt::format("(-{})", of.as_truth()), true};
    return {text, text};
  }
  static std::string comparison(std::string_view sign, const std::string& a, const std::string& b) {
    return fmt::format("({}({} - {}))", sign.front() == '<' ? "-" : "", a, b);
  }
};

}  // namespace

Expression margin_of(const Expression& condition) {
  const auto& variables = condition.variables();
  const auto known = [&](std::string_view name) {
    return std::ranges::find(variables, name) != variables.end();
  };
  const auto margin = fold<Part>(translate(condition.text(), known), MakeMargin{variables}).margin;
  try {
    return Expression(margin, known);
  } catch (const ExpressionError&) {  // too long: the condition itself jumps where its margin passes 0
    return condition;
  }
}

}  // namespace stepwire::expression

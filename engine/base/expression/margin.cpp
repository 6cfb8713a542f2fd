#include "engine/base/expression/margin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/expression/fold.hpp"

namespace stepwire::expression {
namespace {

using Texts = std::vector<std::string>;

/// A part of a condition: its value as text, its margin, and the margins of conditions within it.
struct Part {
  std::string value, margin;
  Texts inner{};
  bool truth = false;

  /// Of a number that stands where a truth is meant, which it is unless it is 0.
  std::string as_truth() const { return truth ? margin : "abs(" + value + ")"; }
  /// Of all conditions that its value shows.
  Texts branches() const { return truth ? Texts{margin} : inner; }
};

std::string joined(const std::vector<Part>& parts) {
  std::string list;
  for (const Part& part : parts) list += (list.empty() ? "" : ", ") + part.value;
  return list;
}

Texts branches_in(const std::vector<Part>& parts) {
  Texts all;
  for (const Part& part : parts)
    for (std::string& margin : part.branches())
      if (std::ranges::find(all, margin) == all.end()) all.push_back(std::move(margin));
  return all;
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
      return {text, text, branches_in(of)};
    }
    const std::string text = fmt::format("({} {} {})", of[0].value, operation.name, of[1].value);
    if (operation.binding == Binding::comparison)
      return {text, comparison(operation.name, of[0].value, of[1].value), {}, true};
    if (operation.binding < Binding::comparison)
      return {text,
              fmt::format("{}({}, {})", operation.binding == Binding::both ? "min" : "max", of[0].as_truth(),
                          of[1].as_truth()),
              {},
              true};
    return {text, text, branches_in(of)};
  }
  Part choice(const Part& condition, const Part& a, const Part& b) const {
    const auto text = [&](const std::string& first, const std::string& second) {
      return fmt::format("({} ? {} : {})", condition.value, first, second);
    };
    const Part decides{"", condition.as_truth(), {}, true};
    return {text(a.value, b.value), text(a.margin, b.margin), branches_in({decides, a, b}),
            a.truth && b.truth};
  }

 private:
  static Part prefix(std::string_view sign, const Part& of) {
    const std::string text = fmt::format("({}{})", sign, of.value);
    if (sign == "!") return {text, fmt::format("(-{})", of.as_truth()), {}, true};
    return {text, text, of.branches()};
  }
  static std::string comparison(std::string_view sign, const std::string& a, const std::string& b) {
    return fmt::format("({}({} - {}))", sign.front() == '<' ? "-" : "", a, b);
  }
};

Part fold_of(const Expression& formula, const std::function<bool(std::string_view)>& known) {
  return fold<Part>(translate(formula.text(), known), MakeMargin{formula.variables()});
}

auto variables_of(const Expression& formula) {
  return [&variables = formula.variables()](std::string_view name) {
    return std::ranges::find(variables, name) != variables.end();
  };
}

}  // namespace

Expression margin_of(const Expression& condition) {
  const auto known = variables_of(condition);
  try {
    return Expression(fold_of(condition, known).margin, known);
  } catch (const ExpressionError&) {  // too long: the condition itself jumps where its margin passes 0
    return condition;
  }
}

Branches branches_of(const Expression& formula) {
  const auto known = variables_of(formula);
  const Part part = fold_of(formula, known);
  Branches branches{part.truth, {}};
  for (const std::string& margin : part.branches()) try {
      branches.margins.emplace_back(margin, known);
    } catch (const ExpressionError&) {  // too long: a truth jumps where its margin passes 0
      if (part.truth) branches.margins.push_back(formula);
    }
  return branches;
}

}  // namespace stepwire::expression

#include "engine/base/expression/margin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/expression/fold.hpp"

namespace stepwire::expression {
namespace {

using Texts = std::vector<std::string>;

/// A subexpression: its value as text, its margin, and the margins of its inner jumps and bends.
struct Part {
  std::string value, margin;
  Texts inner{}, bends{};
  bool truth = false;
  bool steady = false;  ///< constant between sign changes of branches()
  bool varies = true;   ///< depends on a variable

  std::string beside{};  ///< margin beside other conditions, if its sign must be that of the truth

  /// Returns the margin of this value used as a condition; a number is true unless it is 0.
  std::string as_truth() const {
    if (!beside.empty()) return beside;
    return truth ? margin : "abs(" + value + ")";
  }
  /// Returns the margins of all places where the value jumps.
  Texts branches() const { return truth ? Texts{margin} : inner; }
};
using Parts = std::vector<Part>;

std::string joined(const Parts& parts) {
  std::string list;
  for (const Part& part : parts) list += (list.empty() ? "" : ", ") + part.value;
  return list;
}

/// Limit of margins: more do not help a block and make long formulas slow to parse.
constexpr std::size_t most_margins = 16;

void add_once(Texts& all, std::string text) {
  if (all.size() < most_margins && std::ranges::find(all, text) == all.end()) all.push_back(std::move(text));
}

Texts all_of(const Parts& parts, Texts (*texts)(const Part& part)) {
  Texts all;
  for (const Part& part : parts)
    for (std::string& margin : texts(part)) add_once(all, std::move(margin));
  return all;
}

bool all_steady(const Parts& parts) {
  return std::ranges::all_of(parts, &Part::steady);
}
bool any_varies(const Parts& parts) {
  return std::ranges::any_of(parts, &Part::varies);
}

/// Makes a numeric part from its operands.
Part number_of(std::string text, const Parts& of) {
  const bool steady = all_steady(of);
  Part part{text, text, all_of(of, [](const Part& inner) { return inner.branches(); })};
  if (!steady) part.bends = all_of(of, [](const Part& inner) { return inner.bends; });
  part.steady = steady;
  part.varies = any_varies(of);
  return part;
}
Part truth_of(std::string text, std::string margin, const Parts& of) {
  return {std::move(text), std::move(margin), {}, {}, true, true, any_varies(of)};
}

/// Adds margins for min or max: each value minus the best of the values before it.
void add_best(Texts& margins, std::string_view name, const Parts& of) {
  std::string best = of[0].value;
  for (std::size_t i = 1; i < of.size(); ++i) {
    add_once(margins, fmt::format("({} - {})", of[i].value, best));
    best = fmt::format("{}({}, {})", name, best, of[i].value);
  }
}

/// Adds the margin of a function's own jumps and bends: for floor at whole numbers it is sin(pi x).
void add_own(Part& part, std::string_view name, const Parts& of) {
  constexpr const char* pi = "(3.1415926535897931)";
  const std::string& value = of[0].value;
  if (name == "sign") add_once(part.inner, value);
  if (name == "floor" || name == "ceil") add_once(part.inner, fmt::format("sin({}*{})", pi, value));
  if (name == "round") add_once(part.inner, fmt::format("cos({}*{})", pi, value));
  if (name == "mod") add_once(part.inner, fmt::format("sin({}*({} / {}))", pi, value, of[1].value));
  if (name == "abs") add_once(part.bends, value);
  if (name == "min" || name == "max") add_best(part.bends, name, of);
}

Part function_of(std::string_view name, const Parts& of) {
  Part part = number_of(fmt::format("{}({})", name, joined(of)), of);
  if (part.steady) return part;
  add_own(part, name, of);
  part.steady = name == "sign" || name == "floor" || name == "ceil" || name == "round";
  if (part.steady) part.bends.clear();
  return part;
}

/// Builds the margin of an expression bottom-up. The margin of a truth value is positive where it is true and
/// changes sign where it changes. A comparison has the difference of its sides. "and" is the smaller and "or"
/// the larger of two margins; "not" negates one. A choice selects the margin of its branch.
struct MakeMargin {
  const std::vector<std::string>& variables;

  Part variable(std::size_t i) const { return {variables[i], variables[i]}; }
  Part number(const Program::Number& number) const {
    const std::string text = fmt::format("({:.17g})", number.value);
    return {text, text, {}, {}, false, true, false};
  }
  Part operation(const Operation& operation, const Parts& of, std::size_t) const {
    if (operation.binding == Binding::prefix) return prefix(operation.name, of);
    if (operation.binding == Binding::atom) return function_of(operation.name, of);
    const std::string text = fmt::format("({} {} {})", of[0].value, operation.name, of[1].value);
    if (operation.binding == Binding::comparison) return compared(operation.name, text, of);
    if (operation.binding < Binding::comparison)
      return truth_of(text,
                      fmt::format("{}({}, {})", operation.binding == Binding::both ? "min" : "max",
                                  of[0].as_truth(), of[1].as_truth()),
                      of);
    return number_of(text, of);
  }
  Part choice(const Part& condition, const Part& a, const Part& b) const {
    const auto text = [&](const std::string& first, const std::string& second) {
      return fmt::format("({} ? {} : {})", condition.value, first, second);
    };
    const bool truth = a.truth && b.truth;
    const Parts of{condition.steady ? condition : truth_of("", condition.as_truth(), {condition}), a, b};
    Part part = number_of(text(a.value, b.value), of);
    part.margin = text(a.margin, b.margin);
    part.truth = truth;
    part.steady = part.steady || truth;
    if (truth) part.bends.clear();
    return part;
  }

 private:
  static Part prefix(std::string_view sign, const Parts& of) {
    const std::string text = fmt::format("({}{})", sign, of[0].value);
    if (sign == "!") return truth_of(text, fmt::format("(-{})", of[0].as_truth()), of);
    return number_of(text, of);
  }
  /// The difference of two numbers changes its sign where they become equal, which would hide other
  /// conditions beside it. There the distance takes its place.
  static Part compared(std::string_view sign, const std::string& text, const Parts& of) {
    const std::string difference = fmt::format("({} - {})", of[0].value, of[1].value);
    Part part = truth_of(text, fmt::format("({}{})", sign.front() == '<' ? "-" : "", difference), of);
    if (sign == "==") part.beside = fmt::format("(-abs{})", difference);
    if (sign == "!=") part.beside = fmt::format("abs{}", difference);
    return part;
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
  } catch (const ExpressionError&) {  // too long: the condition itself jumps where its margin crosses 0
    return condition;
  }
}

Branches branches_of(const Expression& formula) {
  const auto known = variables_of(formula);
  const Part part = fold_of(formula, known);
  Branches branches{part.steady && part.varies, {}};
  Texts margins = part.branches();
  for (const std::string& bend : part.bends) add_once(margins, bend);
  for (const std::string& margin : margins) try {
      branches.margins.emplace_back(margin, known);
    } catch (const ExpressionError&) {  // too long: a steady value jumps where its margin crosses 0
      if (part.truth) branches.margins.push_back(formula);
      branches.steady = part.truth;
    }
  return branches;
}

}  // namespace stepwire::expression

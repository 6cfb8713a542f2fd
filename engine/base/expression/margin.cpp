#include "engine/base/expression/margin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "engine/base/expression/fold.hpp"

namespace stepwire::expression {
namespace {

/// Branch point: the text of its margin, and that of a value that is constant on each side of it.
struct Point {
  std::string margin, mode;

  bool operator==(const Point&) const = default;
};
using Points = std::vector<Point>;

/// A subexpression: its value as text, its margin, and its inner jumps and bends.
struct Part {
  std::string value, margin;
  std::string held{};  ///< the value, with the modes of known points as variables
  Points inner{}, bends{};
  bool truth = false;
  bool steady = false;  ///< constant between sign changes of branches()
  bool varies = true;   ///< depends on a variable

  std::string beside{};  ///< margin beside other conditions, if its sign must be that of the truth

  /// Returns the margin of this value used as a condition; a number is true unless it is 0.
  std::string as_truth() const {
    if (!beside.empty()) return beside;
    return truth ? margin : "abs(" + value + ")";
  }
  /// Returns all places where the value jumps.
  Points branches() const { return truth ? Points{{margin, value}} : inner; }
};
using Parts = std::vector<Part>;

std::string joined(const Parts& parts, std::string Part::*text) {
  std::string list;
  for (const Part& part : parts) list += (list.empty() ? "" : ", ") + part.*text;
  return list;
}

/// Limit of branch points: more do not help a block and make long formulas slow to parse.
constexpr std::size_t most_points = 16;

void add_once(Points& all, Point point) {
  if (all.size() < most_points && std::ranges::find(all, point) == all.end()) all.push_back(std::move(point));
}

Points all_of(const Parts& parts, Points (*points)(const Part& part)) {
  Points all;
  for (const Part& part : parts)
    for (Point& point : points(part)) add_once(all, std::move(point));
  return all;
}

bool all_steady(const Parts& parts) {
  return std::ranges::all_of(parts, &Part::steady);
}
bool any_varies(const Parts& parts) {
  return std::ranges::any_of(parts, &Part::varies);
}

/// Adds points for min or max: each value minus the best of the values before it.
void add_best(Points& points, std::string_view name, const Parts& of) {
  std::string best = of[0].value;
  for (std::size_t i = 1; i < of.size(); ++i) {
    add_once(points, {fmt::format("({} - {})", of[i].value, best), ""});
    best = fmt::format("{}({}, {})", name, best, of[i].value);
  }
}

/// Returns the margin of a value that jumps by 1: the distance to the nearer jump, with a sign that follows
/// from the value itself. So the value has jumped wherever the sign has changed.
std::string margin_of_steps(const std::string& whole, const std::string& distance) {
  return fmt::format("((mod({}, 2) < 1 ? 1 : -1)*{})", whole, distance);
}

/// Returns the point at which a function jumps.
std::optional<Point> jump_of(std::string_view name, const std::string& text, const Parts& of) {
  const std::string& value = of[0].value;
  const auto between = [&](const std::string& share) { return fmt::format("min({0}, 1 - {0})", share); };
  if (name == "sign") return Point{value, text};
  if (name == "floor")
    return Point{margin_of_steps(text, between(fmt::format("({} - {})", value, text))), text};
  if (name == "ceil")
    return Point{margin_of_steps(text, between(fmt::format("({} - {})", text, value))), text};
  if (name == "round")
    return Point{margin_of_steps(text, fmt::format("(0.5 - abs({} - {}))", value, text)), text};
  if (name != "mod") return std::nullopt;
  const std::string quotient = fmt::format("round(({} - {})/{})", value, text, of[1].value);
  return Point{margin_of_steps(quotient, between(fmt::format("({}/{})", text, of[1].value))), quotient};
}

/// Builds the margin of an expression bottom-up. The margin of a truth value is positive where it is true and
/// changes sign where it changes. A comparison has the difference of its sides. "and" is the smaller and "or"
/// the larger of two margins; "not" negates one. A choice selects the margin of its branch.
struct MakeMargin {
  const std::vector<std::string>& variables;
  const Points& known;      ///< points whose modes are variables of the held text
  const std::string& name;  ///< of these variables, without their numbers

  Part variable(std::size_t i) const { return {variables[i], variables[i], variables[i]}; }
  Part number(const Program::Number& number) const {
    const std::string text = fmt::format("({:.17g})", number.value);
    return {text, text, text, {}, {}, false, true, false};
  }
  Part operation(const Operation& operation, const Parts& of, std::size_t) const {
    if (operation.binding == Binding::prefix) return prefix(operation.name, of);
    if (operation.binding == Binding::atom) return function(operation.name, of);
    const auto text = [&](std::string Part::*side) {
      return fmt::format("({} {} {})", of[0].*side, operation.name, of[1].*side);
    };
    if (operation.binding == Binding::comparison) return compared(operation.name, text(&Part::value), of);
    if (operation.binding < Binding::comparison)
      return truth(text(&Part::value),
                   fmt::format("{}({}, {})", operation.binding == Binding::both ? "min" : "max",
                               of[0].as_truth(), of[1].as_truth()),
                   of);
    return number_of(text(&Part::value), text(&Part::held), of);
  }
  Part choice(const Part& condition, const Part& a, const Part& b) const {
    const auto text = [](const std::string& chooses, const std::string& first, const std::string& second) {
      return fmt::format("({} ? {} : {})", chooses, first, second);
    };
    const bool truths = a.truth && b.truth;
    const Part chooses = condition.steady ? condition
                                          : truth(fmt::format("({} != 0)", condition.value),
                                                  condition.as_truth(), {condition});
    Part part = number_of(text(condition.value, a.value, b.value), text(chooses.held, a.held, b.held),
                          {chooses, a, b});
    part.margin = text(condition.value, a.margin, b.margin);
    part.truth = truths;
    part.steady = part.steady || truths;
    if (truths) part.bends.clear();
    if (truths) part.held = held({part.margin, part.value});
    return part;
  }

 private:
  /// Returns the variable of a known point, else the text of its mode.
  std::string held(const Point& point) const {
    const auto found = std::ranges::find(known, point);
    return found == known.end() ? point.mode : fmt::format("{}{}", name, found - known.begin());
  }
  static Part number_of(std::string text, std::string held, const Parts& of) {
    const bool steady = all_steady(of);
    Part part{text, text, std::move(held), all_of(of, [](const Part& inner) { return inner.branches(); })};
    if (!steady) part.bends = all_of(of, [](const Part& inner) { return inner.bends; });
    part.steady = steady;
    part.varies = any_varies(of);
    return part;
  }
  Part truth(const std::string& text, const std::string& margin, const Parts& of) const {
    return {text, margin, held({margin, text}), {}, {}, true, true, any_varies(of)};
  }
  Part function(std::string_view called, const Parts& of) const {
    const std::string text = fmt::format("{}({})", called, joined(of, &Part::value));
    Part part = number_of(text, fmt::format("{}({})", called, joined(of, &Part::held)), of);
    if (part.steady) return part;
    if (called == "abs") add_once(part.bends, {of[0].value, ""});
    if (called == "min" || called == "max") add_best(part.bends, called, of);
    const auto jump = jump_of(called, text, of);
    if (!jump) return part;
    add_once(part.inner, *jump);
    if (called == "mod") {
      if (std::ranges::find(known, *jump) != known.end()) part.held = held_rest(part.held, held(*jump), of);
      return part;
    }
    part.held = held(*jump);
    part.steady = true;
    part.bends.clear();
    return part;
  }
  /// Returns the text of a remainder whose quotient is held. Where the quotient has not changed it has the
  /// bits of the remainder.
  static std::string held_rest(const std::string& rest, const std::string& quotient, const Parts& of) {
    return fmt::format("({0} + {2}*(round(({1} - {0})/{2}) - {3}))", rest, of[0].held, of[1].held, quotient);
  }
  Part prefix(std::string_view sign, const Parts& of) const {
    const std::string text = fmt::format("({}{})", sign, of[0].value);
    if (sign == "!") return truth(text, fmt::format("(-{})", of[0].as_truth()), of);
    return number_of(text, fmt::format("({}{})", sign, of[0].held), of);
  }
  /// The difference of two numbers changes its sign where they become equal, which would hide other
  /// conditions beside it. There the distance takes its place.
  Part compared(std::string_view sign, const std::string& text, const Parts& of) const {
    const std::string difference = fmt::format("({} - {})", of[0].value, of[1].value);
    Part part = truth(text, fmt::format("({}{})", sign.front() == '<' ? "-" : "", difference), of);
    if (sign == "==") part.beside = fmt::format("(-abs{})", difference);
    if (sign == "!=") part.beside = fmt::format("abs{}", difference);
    return part;
  }
};

Part fold_of(const Expression& formula, const std::function<bool(std::string_view)>& known,
             const Points& points = {}, const std::string& name = "") {
  return fold<Part>(translate(formula.text(), known), MakeMargin{formula.variables(), points, name});
}

/// Returns the points of a formula, jumps first.
Points points_of(const Part& part) {
  Points points = part.branches();
  for (const Point& bend : part.bends) add_once(points, bend);
  return points;
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
  Branches branches{part.steady && part.varies, {}, {}};
  for (const Point& point : points_of(part)) try {
      branches.margins.emplace_back(point.margin, known);
      branches.texts.push_back(point.mode);
    } catch (const ExpressionError&) {  // too long: a steady value jumps where its margin crosses 0
      if (part.truth) branches.margins.push_back(formula), branches.texts.emplace_back();
      branches.steady = part.truth;
    }
  return branches;
}

Held held_of(const Expression& formula, std::size_t most) {
  const auto known = variables_of(formula);
  Points points = points_of(fold_of(formula, known));
  points.resize(std::min(points.size(), most));
  std::erase_if(points, [](const Point& point) { return point.mode.empty(); });
  std::string name = "mode";
  const auto begins = [&](const std::string& variable) { return variable.starts_with(name); };
  while (std::ranges::any_of(formula.variables(), begins)) name += '_';
  Held held{formula, {}, {}};
  try {
    for (const Point& point : points) {
      held.modes.emplace_back(point.mode, known);
      held.names.push_back(fmt::format("{}{}", name, held.names.size()));
    }
    held.formula = Expression(fold_of(formula, known, points, name).held,
                              [&](std::string_view text) { return known(text) || text.starts_with(name); });
    return held;
  } catch (const ExpressionError&) {  // too long
    return {formula, {}, {}};
  }
}

}  // namespace stepwire::expression

// Comparisons, switches and conditions of Simulink.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>

#include "engine/app/simulink/conditions.hpp"
#include "engine/app/simulink/forms.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {
namespace {

void switch_of_three(BlockWriter& write) {
  static const std::map<std::string, std::string> criteria{
      {"u2 >= Threshold", "greater_equal"}, {"u2 > Threshold", "greater"}, {"u2 ~= 0", "not_equal"}};
  const auto found = criteria.find(write.text("Criteria", "u2 >= Threshold"));
  if (found == criteria.end()) throw Untranslated("its criterion is '" + write.text("Criteria") + "'");
  write.make("Switch")
      .key("control", write.source(2))
      .key("then", write.source(1))
      .key("else", write.source(3));
  write.key("criterion", found->second);
  if (found->second == "not_equal")
    write.key("threshold", "0");
  else
    write.key("threshold", cell_node(write.number("Threshold", "0")));
  write.every();
}

void manual_switch(BlockWriter& write) {
  const bool is_first = write.text("sw", write.text("CurrentSetting", "1")) == "1";
  write.output(1, write.source(is_first ? 1 : 2));
  write.deviates(fmt::format("stays at its input {}", is_first ? 1 : 2));
}

void many_switch(BlockWriter& write) {
  const std::string order = write.text("DataPortOrder", "One-based contiguous");
  if (order == "Specify indices") throw Untranslated("its ports have indices of their own");
  const int first = order.starts_with("Zero") ? 0 : 1, count = write.inputs() - 1;
  if (count < 2) throw Untranslated("it has one data port, whose elements are chosen");
  std::string formula;
  for (int i = 0; i + 1 < count; ++i)
    formula += i == 0 ? fmt::format("u1 >= {} && u1 < {} ? u2 : ", first, first + 1)
                      : fmt::format("u1 >= {} && u1 < {} ? u{} : ", first + i, first + i + 1, i + 2);
  expression(write, formula + fmt::format("u{}", count + 1), write.sources()).every();
}

void relation(BlockWriter& write) {
  const std::string sign = write.text("Operator", ">=");
  write.say_default("Operator", ">=");
  if (sign.size() > 2) throw Untranslated("its operator is " + sign);
  write.make("Compare")
      .u()
      .key("operator", quoted(sign == "~=" ? "!=" : sign))
      .key("to", write.source(2))
      .every();
}

void compare_to(BlockWriter& write) {
  const std::string sign = write.text("relop", "<=");
  yaml::Node to = constant_source(write, "constant", write.finite("const", "3.0"));
  write.make("Compare").u().key("operator", quoted(sign == "~=" ? "!=" : sign)).key("to", std::move(to));
}

void compare_to_zero(BlockWriter& write) {
  const std::string sign = write.text("relop", "<=");
  write.make("Compare").u().key("operator", quoted(sign == "~=" ? "!=" : sign)).key("to", "0");
}

/// Returns the formula of a logical operator over inputs that are true where they are not 0.
std::string formula_of(const std::string& function, int count) {
  std::string formula;
  for (int i = 1; i <= count; ++i) {
    const bool is_or = function == "or" || function == "nor";
    const bool is_xor = function == "xor" || function == "xnor";
    if (i > 1) formula += is_or ? " || " : is_xor ? " + " : " && ";
    formula += is_xor ? fmt::format("(u{} != 0)", i) : fmt::format("u{} != 0", i);
  }
  if (function == "xor" || function == "xnor")
    return fmt::format("mod({}, 2) == {}", formula, function == "xor" ? 1 : 0);
  return function.starts_with("n") ? "!(" + formula + ")" : formula;
}

void logic(BlockWriter& write) {
  std::string function = lower_case(write.text("Operator", "AND"));
  if (function == "nxor") function = "xnor";
  const int count = write.inputs();
  if (count == 1 && function != "not" && write.width(1) != 1)
    throw Untranslated("it joins the elements of one input; give them to a Logic one by one");
  bool are_truths = true;
  for (int i = 1; i <= count; ++i) are_truths = are_truths && is_truth(write.model(), write.source(i));
  if (are_truths)
    write.make("Logic").key("operator", function).key("u", list_of(write.sources())).every();
  else
    expression(write, formula_of(function, count), write.sources()).every();
}

void interval(BlockWriter& write) {
  const bool closes_right = write.is_on("IntervalClosedRight", "on"),
             closes_left = write.is_on("IntervalClosedLeft", "on");
  const std::string low = in_formula(write.number("lowlimit", "-0.5")),
                    high = in_formula(write.number("uplimit", "0.5"));
  expression(
      write,
      fmt::format("u1 {} {} && u1 {} {}", closes_left ? ">=" : ">", low, closes_right ? "<=" : "<", high),
      {word(write.source())});
}

void edge(BlockWriter& write, bool falls) {
  if (write.known("vinit", "0") != 0.0) throw Untranslated("its initial value is not 0");
  std::string source = write.source();
  if (falls)
    source = write.extra("negative", block_node("Gain", {{"u", word(source)}, {"gain", word("-1")}}));
  write.make("EdgeDetect").key("u", source).key("edge", "rising");
}

void rise(BlockWriter& write) {
  edge(write, false);
}
void fall(BlockWriter& write) {
  edge(write, true);
}

void change(BlockWriter& write) {
  const std::string before =
      write.extra("before", block_node("UnitDelay", {{"u", word(write.source())},
                                                     {"initial", value_node(write.finite("vinit", "0"))}}));
  expression(write, "u1 != u2", {word(write.source()), word(before)});
}

void if_block(BlockWriter& write) {
  std::vector<std::string> conditions{write.text("IfExpression", "u1 > 0")};
  for (const std::string& one : parts_of(write.text("ElseIfExpressions"), ',')) conditions.push_back(one);
  std::string before;
  int port = 0;
  for (const std::string& text : conditions) {
    const std::string condition = "(" + condition_of(write, text) + ")";
    write.output(++port, before.empty() ? condition : before + " && " + condition);
    before += (before.empty() ? "!" : " && !") + condition;
  }
  write.output(++port, before);
}

/// True for a blank at the end of a case of MATLAB, as in "1 -2"; "1 - 2" is one case.
bool ends_case(const std::string& text, std::size_t blank) {
  const std::size_t before = text.find_last_not_of(' ', blank), after = text.find_first_not_of(' ', blank);
  if (before == text.npos || after == text.npos) return false;
  if (std::string_view("+-*/^:,;").find(text[before]) != std::string_view::npos) return false;
  const bool is_sign = text[after] == '+' || text[after] == '-';
  if (is_sign) return after + 1 < text.size() && text[after + 1] != ' ';
  return std::string_view("*/^:,;").find(text[after]) == std::string_view::npos;
}

/// Returns the cases of a Switch Case, as "1" and "[2,3]" of "{1,[2,3]}".
std::vector<std::string> cases_of(const std::string& written) {
  const std::size_t open = written.find('{'), close = written.rfind('}');
  if (open == written.npos || close == written.npos || close < open)
    throw Untranslated("its cases are '" + written + "'");
  const std::string text = on_one_line(written.substr(open + 1, close - open - 1));
  std::vector<std::string> cases(1);
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    depth += c == '[' || c == '(' || c == '{' ? 1 : c == ']' || c == ')' || c == '}' ? -1 : 0;
    const bool is_end = depth == 0 && (c == ',' || c == ';' || (c == ' ' && ends_case(text, at)));
    if (is_end)
      cases.emplace_back();
    else
      cases.back() += c;
  }
  std::erase_if(cases, [](const std::string& one) { return on_one_line(one).empty(); });
  return cases;
}

/// Returns the condition of a case: the whole input is one of its numbers.
std::string case_condition(BlockWriter& write, const std::string& text, const std::string& whole) {
  std::string condition;
  for (const double number : write.model().evaluate(write.instance(), text).numbers()) {
    if (number != std::round(number)) throw Untranslated("its case " + text + " is no whole number");
    condition += fmt::format("{}{} == {}", condition.empty() ? "" : " || ", whole, in_formula(Cell{number}));
  }
  if (condition.empty()) throw Untranslated("its case " + text + " is empty");
  return condition;
}

void switch_case(BlockWriter& write) {
  const std::string whole =
      write.extra("whole", block_node("Expression", {{"u", word(write.source())},
                                                     {"expression", word("u1 < 0 ? ceil(u1) : floor(u1)")}}));
  std::string any;
  int port = 0;
  for (const std::string& text : cases_of(write.text("CaseConditions", "{1}"))) {
    const std::string condition = case_condition(write, text, whole);
    write.output(++port, "(" + condition + ")" + (any.empty() ? "" : " && !(" + any + ")"));
    any += (any.empty() ? "" : " || ") + condition;
  }
  if (any.empty()) throw Untranslated("its cases are '" + write.text("CaseConditions") + "'");
  write.output(++port, "!(" + any + ")");
}

}  // namespace

std::string condition_of(BlockWriter& write, const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const bool before_is_name =
        at > 0 && (std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0 || text[at - 1] == '_');
    const std::string two = text.substr(at, 2);
    if (c == 'u' && !before_is_name && at + 1 < text.size() &&
        std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0) {
      std::size_t end = at + 1;
      while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
      result += write.source(std::atoi(text.substr(at + 1, end - at - 1).c_str()));
      at = end - 1;
    } else if (two == "~=" || two == "&&" || two == "||") {
      result += two == "~=" ? "!=" : two;
      ++at;
    } else if (c == '&' || c == '|') {
      result += std::string(2, c);
    } else if (std::isalpha(static_cast<unsigned char>(c)) != 0 && !before_is_name) {
      throw Untranslated("its condition is '" + text + "'");
    } else {
      result += c == '~' ? '!' : c;
    }
  }
  return result;
}

std::vector<Translation> logic_translations() {
  return {{"Switch", "`Switch`", switch_of_three},
          {"ManualSwitch", "a wire from the chosen input", manual_switch},
          {"MultiPortSwitch", "`Expression`", many_switch},
          {"RelationalOperator", "`Compare`", relation},
          {"Compare To Constant", "`Compare`", compare_to},
          {"Compare To Zero", "`Compare`", compare_to_zero},
          {"Logic", "`Logic`, or `Expression` where inputs are not 0 or 1", logic},
          {"Interval Test", "`Expression`", interval},
          {"Detect Rise Positive", "`EdgeDetect`", rise},
          {"Detect Fall Negative", "`EdgeDetect`", fall},
          {"Detect Change", "`Expression` with a `UnitDelay`", change},
          {"If", "conditions of parts", if_block},
          {"SwitchCase", "conditions of parts", switch_case}};
}

}  // namespace stepwire::simulink

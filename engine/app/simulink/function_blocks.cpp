// Functions of Simulink: Math, Trigonometry, Rounding, Sqrt, Fcn.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "engine/app/simulink/forms.hpp"
#include "engine/app/simulink/functions.hpp"

namespace stepwire::simulink {
namespace {

void math(BlockWriter& write) {
  static const std::map<std::string, std::string> formulas{{"exp", "exp(u1)"},
                                                           {"log", "log(u1)"},
                                                           {"10^u", "10^u1"},
                                                           {"log10", "log10(u1)"},
                                                           {"magnitude^2", "u1*u1"},
                                                           {"square", "u1*u1"},
                                                           {"sqrt", "sqrt(u1)"},
                                                           {"conj", "u1"},
                                                           {"reciprocal", "1/u1"},
                                                           {"pow", "u1^u2"},
                                                           {"hypot", "hypot(u1, u2)"},
                                                           {"mod", "u2 == 0 ? u1 : mod(u1, u2)"},
                                                           {"rem", "sign(u1)*mod(abs(u1), abs(u2))"}};
  const std::string function = write.text("Operator", write.text("Function", "exp"));
  if (function == "transpose" || function == "hermitian") {
    write.make("Transpose").u();
    return;
  }
  const auto found = formulas.find(function);
  if (found == formulas.end()) throw Untranslated("its function is " + function);
  expression(write, found->second, write.sources()).every();
}

void sqrt(BlockWriter& write) {
  const std::string function = write.text("Operator", write.text("Function", "sqrt"));
  if (function == "rSqrt") {
    expression(write, "1/sqrt(u1)", {word(write.source())});
    return;
  }
  write.make("Sqrt").u();
  if (function == "signedSqrt") write.key("signed", "true");
}

/// Writes both outputs of sincos.
void sine_and_cosine(BlockWriter& write) {
  const std::string cosine =
      write.extra("cos", block_node("Trig", {{"u", word(write.source())}, {"function", word("cos")}}));
  write.make("Trig").u().key("function", "sin").output(2, cosine);
}

void trigonometry(BlockWriter& write) {
  static const std::map<std::string, std::string> inverse{{"asinh", "log(u1 + sqrt(u1*u1 + 1))"},
                                                          {"acosh", "log(u1 + sqrt(u1*u1 - 1))"},
                                                          {"atanh", "0.5*log((1 + u1)/(1 - u1))"}};
  const std::string function = write.text("Operator", write.text("Function", "sin"));
  if (function == "cos + jsin") throw Untranslated("its output is complex");
  if (function == "sincos") return sine_and_cosine(write);
  if (const auto found = inverse.find(function); found != inverse.end()) {
    expression(write, found->second, {word(write.source())}).every();
    return;
  }
  if (function == "atan2")
    write.make("Atan2").key("opposite", write.source(1)).key("adjacent", write.source(2)).every();
  else
    write.make("Trig").u().key("function", function).every();
}

void rounding(BlockWriter& write) {
  const std::string function = write.text("Operator", write.text("Function", "floor"));
  const bool is_fix = function == "fix";
  expression(write, is_fix ? "sign(u1)*floor(abs(u1))" : function + "(u1)", {word(write.source())}).every();
}

bool is_name_part(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The formula of a block Fcn with its elements as inputs: u(2), u[2] and u.
class Formula {
 public:
  Formula(BlockWriter& write, std::string text) : write_(write), text_(std::move(text)) {}

  void translate() {
    for (std::size_t at = 0; at < text_.size();) at = step(at);
    expression(write_, result_, inputs());
  }

 private:
  std::size_t step(std::size_t at) {
    const char c = text_[at];
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_') return name(at);
    const bool is_digit = std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.';
    if (is_digit) return number(at);
    if (c == '~' || (c == '!' && text_.substr(at, 2) != "!=")) {
      result_ += text_.substr(at, 2) == "~=" ? "!=" : "!";
      return at + (text_.substr(at, 2) == "~=" ? 2 : 1);
    }
    if (c == '&' || c == '|') {
      result_ += std::string(2, c);
      return at + (at + 1 < text_.size() && text_[at + 1] == c ? 2 : 1);
    }
    result_ += c;
    return at + 1;
  }

  std::size_t number(std::size_t at) {
    while (at < text_.size()) {
      const char c = text_[at];
      const bool is_exponent = (c == '+' || c == '-') && (result_.ends_with("e") || result_.ends_with("E"));
      if (!is_exponent && !is_name_part(c) && c != '.') break;
      result_ += c;
      ++at;
    }
    return at;
  }

  std::size_t name(std::size_t at) {
    std::size_t end = at;
    while (end < text_.size() && is_name_part(text_[end])) ++end;
    const std::string name = text_.substr(at, end - at);
    while (end < text_.size() && text_[end] == ' ') ++end;
    const char next = end < text_.size() ? text_[end] : '\0';
    if (name == "u") return input(end, next);
    if (next == '(')
      result_ += function(name);
    else
      result_ += name == "pi" ? name : constant(name);
    return end;
  }

  std::string constant(const std::string& name) const {
    const Value value = write_.model().evaluate(write_.instance(), name);
    if (value.is_missing && write_.block().type == "MATLABFcn")
      throw Untranslated("its formula has the name " + name);
    return in_formula(value.cells.at(0));
  }

  static std::string function(const std::string& name) {
    static const std::set<std::string> same{"sin",   "cos",  "tan",  "asin",  "acos", "atan",
                                            "atan2", "sinh", "cosh", "tanh",  "exp",  "abs",
                                            "floor", "ceil", "sqrt", "log10", "hypot"};
    if (same.contains(name)) return name;
    if (name == "ln" || name == "log") return "log";
    if (name == "sgn") return "sign";
    throw Untranslated(fmt::format("its formula has the function {}", name));
  }

  std::size_t input(std::size_t end, char next) {
    int element = 1;
    if (next == '(' || next == '[') {
      const std::size_t close = text_.find(next == '(' ? ')' : ']', end);
      if (close == text_.npos) throw Untranslated("its formula has a bracket that is not closed");
      element = std::atoi(text_.substr(end + 1, close - end - 1).c_str());
      end = close + 1;
    }
    if (element < 1 || element > 1000) throw Untranslated("its formula has an element that is no number");
    most_ = std::max(most_, element);
    result_ += fmt::format("u{}", element);
    return end;
  }

  /// Returns the elements of the input: the wires of a Mux of numbers, or elements by their index.
  std::vector<yaml::Node> inputs() const {
    const std::string source = write_.source();
    if (most_ <= 1 && write_.width(1) <= 1) return {word(source)};
    std::vector<yaml::Node> all;
    for (int i = 1; i <= std::max(most_, 1); ++i) all.push_back(word(fmt::format("{}.{}", source, i)));
    return all;
  }

  BlockWriter& write_;
  std::string text_, result_;
  int most_ = 0;
};

/// Returns the formula of an Interpreted MATLAB Function: "sin(u)" of the name alone.
std::string interpreted(const BlockWriter& write) {
  const std::string text = write.text("MATLABFcn", "sin");
  const bool is_name = std::ranges::all_of(text, is_name_part);
  if (is_name && !is_function(text, 1)) throw Untranslated("its function " + text + " is a file of MATLAB");
  return is_name ? text + "(u)" : text;
}

void formula(BlockWriter& write) {
  const bool is_interpreted = write.block().type == "MATLABFcn";
  if (!is_interpreted) write.say_default("Expr", "sin(u[1])");
  try {
    Formula(write, is_interpreted ? interpreted(write) : write.text("Expr", "sin(u[1])")).translate();
  } catch (const ValueError& error) {
    throw Untranslated(std::string("its formula ") + error.what());
  }
}

}  // namespace

std::vector<Translation> function_translations() {
  return {{"Math", "`Expression`, `Transpose`", math},
          {"Sqrt", "`Sqrt`", sqrt},
          {"Trigonometry", "`Trig`, `Atan2`", trigonometry},
          {"Rounding", "`Expression`", rounding},
          {"Fcn", "`Expression`", formula},
          {"MATLABFcn", "`Expression` of a formula", formula}};
}

}  // namespace stepwire::simulink

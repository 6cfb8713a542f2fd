// Functions of Simulink: Math, Trigonometry, Rounding, Sqrt, Fcn.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

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

/// An operator of a formula.
struct Operator {
  std::string_view sign;
  int level;  ///< in the order of precedence; a greater one binds stronger
  std::string_view written;
  int strength;  ///< of the written sign: 1 ||, 2 && and !, 5 comparison, 6 sum, 7 product, 8 sign, 9 power
};

constexpr int level_of_signs = 8;
constexpr int atom = 10;  // strength of what needs no brackets

constexpr Operator sums_and_products[] = {{"+", 6, " + ", 6}, {"-", 6, " - ", 6}, {"*", 7, "*", 7},
                                          {"/", 7, "/", 7},   {".*", 7, "*", 7},  {"./", 7, "/", 7}};
constexpr Operator orders[] = {
    {"<=", 5, " <= ", 5}, {">=", 5, " >= ", 5}, {"<", 5, " < ", 5}, {">", 5, " > ", 5}};
// MATLAB: | binds stronger than &&, and all comparisons alike. Longer signs come first.
constexpr Operator truths_of_matlab[] = {{"||", 1, " || ", 1}, {"&&", 2, " && ", 2}, {"|", 3, " || ", 1},
                                         {"&", 4, " && ", 2},  {"==", 5, " == ", 5}, {"~=", 5, " != ", 5}};
// Fcn: as in C.
constexpr Operator truths_of_fcn[] = {{"||", 1, " || ", 1}, {"&&", 2, " && ", 2}, {"|", 1, " || ", 1},
                                      {"&", 2, " && ", 2},  {"==", 4, " == ", 5}, {"~=", 4, " != ", 5},
                                      {"!=", 4, " != ", 5}};

/// A piece of a written formula.
struct Piece {
  std::string text;
  int strength = atom;  ///< of its weakest operator
};

std::string in_brackets(const Piece& piece, bool has_brackets) {
  return has_brackets ? "(" + piece.text + ")" : piece.text;
}

/// Returns a op b, whose signs are read from left to right.
Piece joined(const Piece& a, const Operator& op, const Piece& b) {
  const bool is_chain = op.strength == 6 || op.strength == 7;
  const std::string left =
      in_brackets(a, a.strength < op.strength || (a.strength == op.strength && !is_chain));
  const std::string right = in_brackets(b, b.strength <= op.strength || b.text.starts_with('-'));
  return {left + std::string(op.written) + right, op.strength};
}

/// The formula of a block Fcn, or of an Interpreted MATLAB Function, with the precedence of its language and
/// the elements of its input as inputs: u(2), u[2] and u.
class Formula {
 public:
  Formula(BlockWriter& write, std::string text)
      : write_(write), is_matlab_(write.block().type == "MATLABFcn"), text_(std::move(text)) {}

  void translate() {
    const Piece whole = binary(1);
    if (at_ < text_.size()) unexpected();
    expression(write_, whole.text, inputs());
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void skip() {
    while (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r') ++at_;
  }

  bool take(std::string_view sign) {
    skip();
    if (std::string_view(text_).substr(at_, sign.size()) != sign) return false;
    at_ += sign.size();
    skip();
    return true;
  }

  [[noreturn]] void unexpected() const {
    if (at_ >= text_.size()) throw Untranslated("its formula ends too early");
    throw Untranslated(fmt::format("its formula has '{}', which is not translated there", text_[at_]));
  }

  /// Returns the operator at the present place; nullptr if there is none.
  const Operator* next_operator() const {
    const auto in = [&](const auto& all) {
      const auto found = std::ranges::find_if(
          all, [&](const Operator& op) { return std::string_view(text_).substr(at_).starts_with(op.sign); });
      return found == std::end(all) ? nullptr : &*found;
    };
    const Operator* truth = is_matlab_ ? in(truths_of_matlab) : in(truths_of_fcn);
    if (truth) return truth;
    const Operator* order = in(orders);
    return order ? order : in(sums_and_products);
  }

  Piece binary(int level) {
    if (level == level_of_signs) return with_sign();
    Piece left = binary(level + 1);
    for (skip();; skip()) {
      const Operator* op = next_operator();
      if (!op || op->level != level) return left;
      at_ += op->sign.size();
      left = joined(left, *op, binary(level + 1));
    }
  }

  /// Reads signs before a power, or before its exponent.
  Piece with_sign(bool is_exponent = false) {
    if (++depth_ > 200) throw Untranslated("its formula is nested too deeply");
    Piece piece;
    if (take("-")) {
      const Piece inner = with_sign(is_exponent);
      piece = {"-" + in_brackets(inner, inner.strength < atom), 8};
    } else if (take("+")) {
      piece = with_sign(is_exponent);
    } else if (take("~") || take("!")) {
      const Piece inner = with_sign(is_exponent);
      piece = {"!" + in_brackets(inner, inner.strength < atom), 2};
    } else {
      piece = is_exponent ? operand() : power();
    }
    --depth_;
    return piece;
  }

  /// Reads a^b^c, which is (a^b)^c.
  Piece power() {
    Piece base = operand();
    while (take(".^") || take("^")) {
      const Piece exponent = with_sign(true);
      base = {in_brackets(base, base.strength < atom) + "^" + in_brackets(exponent, exponent.strength < atom),
              9};
    }
    return base;
  }

  /// Reads a number, a name, a call or brackets. A transposed number is the number.
  Piece operand() {
    skip();
    Piece piece;
    if (is_name_start(peek()))
      piece.text = name();
    else if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1))))
      piece.text = number();
    else if (take("("))
      piece = in_round();
    else
      unexpected();
    while (is_matlab_ && (take(".'") || take("'"))) continue;
    return piece;
  }

  Piece in_round() {
    Piece piece = binary(1);
    if (!take(")")) throw Untranslated("its formula has a bracket that is not closed");
    return piece;
  }

  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
  static bool is_name_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

  std::string number() {
    const std::size_t start = at_;
    while (is_digit(peek())) ++at_;
    if (peek() == '.' && std::string_view("*/^'").find(peek(1)) == std::string_view::npos) ++at_;
    while (is_digit(peek())) ++at_;
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 2 : 1;
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(sign))) at_ += sign;
    while (is_digit(peek())) ++at_;
    if (is_name_part(peek())) unexpected();
    return text_.substr(start, at_ - start);
  }

  std::string name() {
    const std::size_t start = at_;
    while (is_name_part(peek())) ++at_;
    const std::string name = text_.substr(start, at_ - start);
    skip();
    if (name == "u") return input();
    if (peek() == '(') return call(name);
    return name == "pi" ? name : constant(name);
  }

  std::string call(const std::string& name) {
    std::string text = function(name) + "(";
    take("(");
    text += binary(1).text;
    while (take(",")) text += ", " + binary(1).text;
    if (!take(")")) throw Untranslated("its formula has a bracket that is not closed");
    return text + ")";
  }

  std::string constant(const std::string& name) const {
    const Value value = write_.model().evaluate(write_.instance(), name);
    if (value.is_missing && write_.block().type == "MATLABFcn")
      throw Untranslated("its formula has the name " + name);
    if (!value.is_scalar()) throw Untranslated("its formula has " + name + ", which is no single number");
    return in_formula(value.cells[0]);
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

  std::string input() {
    int element = 1;
    if (peek() == '(' || peek() == '[') {
      const std::size_t close = text_.find(peek() == '(' ? ')' : ']', at_);
      if (close == text_.npos) throw Untranslated("its formula has a bracket that is not closed");
      const std::string index = text_.substr(at_ + 1, close - at_ - 1);
      if (index.find_first_not_of("0123456789 ") != index.npos)
        throw Untranslated("its formula has an element that is no number");
      element = std::atoi(index.c_str());
      at_ = close + 1;
    } else if (is_matlab_ && write_.width(1) > 1) {
      throw Untranslated("its formula has the whole vector u");
    }
    if (element < 1 || element > 1000) throw Untranslated("its formula has an element that is no number");
    most_ = std::max(most_, element);
    return fmt::format("u{}", element);
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
  bool is_matlab_;
  std::string text_;
  std::size_t at_ = 0;
  int most_ = 0, depth_ = 0;
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

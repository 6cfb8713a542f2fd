#include "engine/base/expression/program.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

#include "engine/base/expression/draws.hpp"
#include "engine/base/expression/expression.hpp"
#include "engine/base/text/nearest.hpp"

namespace stepwire::expression {
namespace {

/// A token of an expression. The value of a number is SI where it carries a unit.
struct Token {
  enum class Kind { number, name, sign, end };
  Kind kind = Kind::end;
  std::string_view text;
  std::size_t position = 0;
  double value = 0.0;
  std::optional<unit::Dimension> dimension{};  ///< of a number that carries a unit
  bool has_offset = false;                     ///< true for a number in degC or degF

  bool is(std::string_view sign) const { return kind == Kind::sign && text == sign; }
};

using Known = std::function<bool(std::string_view)>;

constexpr std::array<std::string_view, 21> signs{"<=", ">=", "==", "!=", "&&", "||", "+", "-", "*", "/", "^",
                                                 "(",  ")",  "<",  ">",  "!",  "?",  ":", ",", "[", "]"};

/// Syntax of other languages, and the hint to the right one here.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> habits{{
    {"=", "an expression assigns nothing; to compare write '=='"},
    {"&", "write '&&'"},
    {"|", "write '||'"},
    {"%", "the remainder is mod(x, y)"},
    {"\"", "an expression has no text"},
    {"'", "an expression has no text"},
}};

constexpr const char* letters_and_digits = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool is_letter(char c) {
  const char lower = static_cast<char>(c | 0x20);
  return (lower >= 'a' && lower <= 'z') || c == '_';
}

class Lexer {
 public:
  Lexer(std::string_view text, const Known& known) : text_(text), known_(known) {}

  Token next() {
    skip_blanks();
    if (at_ == text_.size()) return {Token::Kind::end, {}, at_, 0.0};
    if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) return number();
    if (is_letter(peek())) return name();
    return sign();
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void skip_blanks() {
    while (is_blank(peek())) ++at_;
  }

  Token finish(Token::Kind kind, std::size_t first, double value = 0.0) const {
    return {kind, text_.substr(first, at_ - first), first, value, {}};
  }

  Token number() {
    const std::size_t first = at_;
    double value = 0.0;
    const char* const end = text_.data() + text_.size();
    const auto [rest, error] = std::from_chars(text_.data() + at_, end, value);
    at_ = static_cast<std::size_t>(rest - text_.data());
    const auto unit = take_unit();
    if (unit) value = unit->to_si(value);
    if (error != std::errc{} || !std::isfinite(value)) {
      throw ExpressionError(fmt::format("'{}' is out of range", text_.substr(first, at_ - first)), first);
    }
    Token token = finish(Token::Kind::number, first, value);
    if (unit) token.dimension = unit->dimension;
    token.has_offset = unit && unit->offset != 0.0L;
    return token;
  }

  /// Consumes the unit of a number. "5 1/s" is a number with a unit, "51/s" is a quotient.
  std::optional<unit::Unit> take_unit() {
    const std::size_t before = at_;
    skip_blanks();
    const std::string_view rest = text_.substr(at_);
    const bool apart = at_ > before || peek() != '1';
    std::size_t length = apart ? unit::unit_prefix(rest, known_) : 0;
    if (length == 0) {
      at_ = before;
      return std::nullopt;
    }
    // A blank multiplies units, as in "0.4 N s/m"; between values a blank is an error anyway.
    for (std::size_t more = next_unit(rest, length); more > length; more = next_unit(rest, length))
      length = more;
    at_ += length;
    return unit::parse_unit(rest.substr(0, length));
  }

  /// Returns the end of a further unit after blanks; `end` if there is none.
  std::size_t next_unit(std::string_view rest, std::size_t end) const {
    const std::size_t next = rest.find_first_not_of(' ', end);
    if (next == std::string_view::npos || next == end || !is_letter(rest[next])) return end;
    if (known_ && known_(name_at(rest.substr(next)))) return end;
    const std::size_t length = unit::unit_prefix(rest.substr(next), known_);
    const bool called = next + length < rest.size() && rest[next + length] == '(';
    if (length == 0 || called || !unit::parse_unit(rest.substr(0, next + length))) return end;
    return next + length;
  }

  static std::string_view name_at(std::string_view text) {
    const auto goes_on = [](char c) { return is_letter(c) || is_digit(c) || c == '.'; };
    return text.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(text, goes_on) - text.begin()));
  }

  Token name() {
    const std::size_t first = at_;
    while (word() || (peek() == '.' && name_goes_on()) || index()) {
    }
    return finish(Token::Kind::name, first);
  }

  bool word() {
    const std::size_t before = at_;
    while (is_letter(peek()) || is_digit(peek())) ++at_;
    return at_ > before;
  }

  /// Consumes the dot of "rig.x".
  bool name_goes_on() {
    const bool on = is_letter(peek(1)) || is_digit(peek(1));
    at_ += on ? 1 : 0;
    return on;
  }

  /// Consumes the index of "rig.x[2]".
  bool index() {
    std::size_t length = 1;
    while (is_digit(peek(length))) ++length;
    const bool is = peek() == '[' && length > 1 && peek(length) == ']';
    at_ += is ? length + 1 : 0;
    return is;
  }

  Token sign() {
    for (const std::string_view sign : signs) {
      if (text_.substr(at_).starts_with(sign)) {
        at_ += sign.size();
        return finish(Token::Kind::sign, at_ - sign.size());
      }
    }
    throw ExpressionError(strange(), at_);
  }

  std::string strange() const {
    for (const auto& [habit, cure] : habits) {
      if (text_.substr(at_).starts_with(habit)) return fmt::format("unexpected {}; {}", habit, cure);
    }
    if (peek() >= 0 && peek() < ' ')
      return fmt::format("unexpected character {:#04x}", static_cast<int>(peek()));
    std::size_t length = 1;  // all bytes of a UTF-8 character
    while ((static_cast<unsigned char>(peek(length)) & 0xC0) == 0x80) ++length;
    return fmt::format("unexpected '{}'", text_.substr(at_, length));
  }

  std::string_view text_;
  const Known& known_;
  std::size_t at_ = 0;
};

/// Splits a text into tokens; the last one has kind `end`. After an operator inside a unit, a `known` word is
/// a name: "4 A/m" is 4 A over m where m is known. Throws ExpressionError.
std::vector<Token> tokens(std::string_view text, const Known& known) {
  Lexer lexer(text, known);
  std::vector<Token> result;
  do result.push_back(lexer.next());
  while (result.back().kind != Token::Kind::end);
  return result;
}

constexpr std::size_t deepest = 200;

/// A pending operator, sign or parenthesis on the stack; the whole text counts as a parenthesis.
struct Waiting {
  Binding binding;
  const Token* token = nullptr;
  const Operation* operation = nullptr;  ///< of a parenthesis: its function; nullptr without one
  int values = 1;
  std::size_t instruction = 0;  ///< of '?' its branch, of ':' its jump
};

Instruction::Kind kind_of(const Operation& operation) {
  using Kind = Instruction::Kind;
  if (operation.binding == Binding::sum) return operation.name == "+" ? Kind::sum : Kind::difference;
  if (operation.binding == Binding::product) return operation.name == "*" ? Kind::product : Kind::quotient;
  return Kind::operation;
}

/// Operator-precedence parser. Values and operators alternate; pending operators are on an explicit stack, so
/// that deep nesting cannot exhaust the call stack.
class Translator {
 public:
  Translator(std::string_view text, const Known& known, Values values, const Known& hides)
      : tokens_(tokens(text, known)), known_(known), hides_(hides), values_(values) {
    program_.text = text;
  }

  Program run() {
    if (tokens_.size() == 1) throw ExpressionError("the expression is empty", 0);
    waiting_.push_back({Binding::open});
    for (; tokens_[at_].kind != Token::Kind::end; ++at_) {
      value_comes_ ? value(tokens_[at_]) : sign(tokens_[at_]);
    }
    finish(tokens_[at_]);
    return std::move(program_);
  }

 private:
  [[noreturn]] static void fail(const Token& token, const std::string& message) {
    throw ExpressionError(message, token.position);
  }

  static std::string shown(const Token& token) {
    return token.kind == Token::Kind::end ? "the end" : fmt::format("'{}'", token.text);
  }

  void value(const Token& token) {
    if (token.kind == Token::Kind::number) return number({token.value, token.dimension, token.has_offset});
    if (token.kind == Token::Kind::name) return name(token);
    if (token.is("(")) return open(token, nullptr);
    if (token.is("[")) return open_brackets(token);
    if (token.is("-") || token.is("!")) return prefix(token.is("-"));
    if (!token.is("+")) missing_value(token);
  }

  [[noreturn]] void missing_value(const Token& token) const {
    const bool power = at_ > 0 && token.is("*") && tokens_[at_ - 1].is("*");
    fail(token, fmt::format("a value is missing before {}{}", shown(token), power ? "; a power is x^y" : ""));
  }

  void number(const Program::Number& number) {
    operand(Instruction::Kind::number, program_.numbers.size());
    program_.numbers.push_back(number);
  }

  void operand(Instruction::Kind kind, std::size_t index) {
    take_prefixes();
    program_.code.push_back({kind, 0, index});
    value_comes_ = false;
  }

  void name(const Token& token) {
    const bool called = tokens_[at_ + 1].is("(");
    const bool exists = (known_ && known_(token.text)) || (hides_ && hides_(token.text));
    if (called) return call(token, exists);
    if (!exists && token.text == "pi") return number({std::numbers::pi, {}});
    if (!exists && token.text == "e") return number({std::numbers::e, {}});
    if (!exists && find_function(token.text))
      fail(token, fmt::format("'{0}' is a function; write {0}(...)", token.text));
    if (!exists && known_) fail(token, fmt::format("unknown name '{}'", token.text));
    variable(token);
  }

  void variable(const Token& token) {
    const auto [place, added] = variables_.try_emplace(token.text, program_.variables.size());
    if (added) program_.variables.emplace_back(token.text);
    program_.uses.push_back({place->second, token.position});
    operand(Instruction::Kind::variable, place->second);
  }

  void call(const Token& token, bool exists) {
    const Operation* function = find_function(token.text);
    const Operation* const of_matrices = function ? nullptr : find_matrix_function(token.text);
    if (of_matrices && values_ == Values::numbers && !exists)
      fail(token,
           fmt::format("'{}' is a function of matrices, which only parameters are; define a parameter by "
                       "it, '= {}(...)'",
                       token.text, token.text));
    if (!function && values_ == Values::matrices) function = of_matrices;
    if (!function)
      fail(token, exists ? fmt::format("'{}' is a value, not a function", token.text)
                         : fmt::format("unknown function '{}'{}", token.text,
                                       text::or_nearest(std::string(token.text), function_names())));
    open(tokens_[++at_], function);
  }

  void open_brackets(const Token& token) {
    if (values_ == Values::numbers)
      fail(token,
           "a list or a matrix in brackets stands in parameters only; an expression is of single numbers");
    open(token, &brackets);
  }

  void open(const Token& token, const Operation* function) {
    if (open_.size() >= deepest) fail(token, fmt::format("more than {} parentheses are open", deepest));
    take_prefixes();
    open_.push_back(waiting_.size());
    waiting_.push_back({Binding::open, &token, function});
    value_comes_ = true;
  }

  /// Collects a prefix sign. A minus inside a "not" has no effect.
  void prefix(bool minus) {
    if (minus && nots_ == 0) negative_ = !negative_;
    if (!minus) nots_ = nots_ == 1 ? 2 : 1;
  }

  void take_prefixes() {
    if (negative_) waiting_.push_back({Binding::prefix, &tokens_[at_], &minus});
    for (; nots_ > 0; --nots_) waiting_.push_back({Binding::prefix, &tokens_[at_], &negation});
    negative_ = false;
  }

  void sign(const Token& token) {
    if (token.is(")") || token.is("]")) return close(token);
    value_comes_ = true;
    if (token.is(",")) return next_value(token);
    if (token.is("?")) return question(token);
    if (token.is(":")) return answer(token);
    const Operation* const operation = find_operator(token.text);
    if (!operation) missing_operator(token);
    if (operation->binding == Binding::comparison) refuse_chain(token);
    settle(operation->binding == Binding::power ? Binding::atom : operation->binding);
    waiting_.push_back({operation->binding, &token, operation, 2});
  }

  [[noreturn]] static void missing_operator(const Token& token) {
    const bool power = token.text == "e" || token.text == "E";
    fail(token, fmt::format("an operator is missing before {}{}", shown(token),
                            power ? "; a power of ten has no blanks, as in 2e-3" : ""));
  }

  /// Throws for a second comparison, which would compare the result 0 or 1 of the first one.
  void refuse_chain(const Token& token) {
    settle(Binding::sum);
    if (waiting_.back().binding == Binding::comparison)
      fail(token,
           fmt::format("'{}' follows on a comparison; write a < b && b < c, or parentheses", token.text));
  }

  void next_value(const Token& token) {
    if (open_.empty() || !waiting_[open_.back()].operation)
      fail(token, "',' only separates the values of a function or a list");
    settle(Binding::condition);
    ++waiting_.back().values;
  }

  void question(const Token& token) {
    settle(Binding::either);
    add_choice(token, Instruction::Kind::branch);
  }

  void answer(const Token& token) {
    while (!is_question(waiting_.back())) {
      if (waiting_.back().binding == Binding::open) fail(token, "':' without '?'");
      apply();
    }
    program_.code[waiting_.back().instruction].index = program_.code.size();
    waiting_.pop_back();
    add_choice(token, Instruction::Kind::jump);
  }

  void add_choice(const Token& token, Instruction::Kind kind) {
    waiting_.push_back({Binding::condition, &token, nullptr, 3, program_.code.size()});
    program_.code.push_back({kind});
  }

  static bool is_question(const Waiting& waiting) {
    return waiting.binding == Binding::condition && waiting.token->is("?");
  }

  void close(const Token& token) {
    const char* const opening = token.is(")") ? "(" : "[";
    if (open_.empty() || !waiting_[open_.back()].token->is(opening))
      fail(token, fmt::format("'{}' without '{}'", token.text, opening));
    settle(Binding::condition);
    const Waiting opened = take_waiting();
    open_.pop_back();
    if (!opened.operation) return;
    if (opened.operation == &brackets) return add_operation(brackets, opened.values, *opened.token);
    const Token& name = *(opened.token - 1);
    check_arity(*opened.operation, opened.values, name);
    add_operation(*opened.operation, opened.values, name);
  }

  static void check_arity(const Operation& function, int values, const Token& name) {
    if (values >= function.least && values <= function.most) return;
    if (name.text == "min" || name.text == "max")
      fail(name, fmt::format("'{0}' of one value is that value; {0}(a, b) compares several, and the {1} "
                             "of a recording is the reduction of a claim, '{0}: ...'",
                             name.text, name.text == "min" ? "smallest" : "largest"));
    fail(name, fmt::format("'{}' takes {} value{}, not {}", name.text, function.least,
                           function.least == 1 ? "" : "s", values));
  }

  /// Applies the pending operators that bind at least as strongly as `least`.
  void settle(Binding least) {
    while (waiting_.back().binding >= least) apply();
  }

  void apply() {
    const Waiting top = take_waiting();
    if (is_question(top)) fail(*top.token, "'?' without ':'");
    if (top.operation) return add_operation(*top.operation, top.values, *top.token);
    program_.code[top.instruction].index = program_.code.size();
    program_.code.push_back({Instruction::Kind::choice, 3, program_.code.size()});
  }

  Waiting take_waiting() {
    const Waiting taken = waiting_.back();
    waiting_.pop_back();
    return taken;
  }

  void add_operation(const Operation& operation, int values, const Token& token) {
    program_.code.push_back({kind_of(operation), values, token.position, &operation});
  }

  void finish(const Token& end) {
    if (value_comes_) fail(end, "a value is missing at the end");
    if (!open_.empty()) {
      const Token& opened = *waiting_[open_.back()].token;
      fail(opened, fmt::format("'{}' without '{}'", opened.text, opened.is("(") ? ")" : "]"));
    }
    settle(Binding::condition);
  }

  const std::vector<Token> tokens_;
  const Known &known_, &hides_;
  const Values values_;
  Program program_;
  std::vector<Waiting> waiting_;
  std::vector<std::size_t> open_;  ///< indices of open parentheses in it
  std::map<std::string_view, std::size_t> variables_;
  bool negative_ = false;
  int nots_ = 0;
  std::size_t at_ = 0;
  bool value_comes_ = true;
};

}  // namespace

Program translate(std::string_view text, const Known& known, Values values, const Known& hides) {
  if (text.size() > longest_text) {
    throw ExpressionError(fmt::format("an expression has at most {} characters", longest_text), longest_text);
  }
  Program program = Translator(text, known, values, hides).run();
  check_draws(program, std::vector<std::optional<double>>(program.variables.size()));
  return program;
}

}  // namespace stepwire::expression

#include "engine/app/simulink/matlab.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>

#include "engine/app/simulink/functions.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {
namespace {

constexpr int max_depth = 200;
constexpr std::size_t max_length = 1'000'000;

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Parser that evaluates while it reads. Within [ ] blanks separate elements.
class Parser {
 public:
  Parser(std::string_view text, const Variables& variables) : text_(text), variables_(variables) {}

  Value run() {
    Value value = range();
    skip();
    while (peek() == ';' || peek() == ',') {
      ++at_;
      skip();
    }
    if (at_ < text_.size()) fail(fmt::format("has '{}' where its end is expected", text_[at_]));
    return value;
  }

 private:
  /// Counts the depth of nested calls.
  struct Depth {
    explicit Depth(Parser& parser) : of(parser) {
      if (++of.depth_ > max_depth) fail("is nested too deeply");
    }
    Depth(const Depth&) = delete;
    ~Depth() { --of.depth_; }
    Parser& of;
  };

  [[noreturn]] static void fail(const std::string& what) { throw ValueError(what); }

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool is_blank(char c) const {
    return c == ' ' || c == '\t' || (brackets_ == 0 && (c == '\n' || c == '\r'));
  }
  void skip() {
    while (is_blank(peek())) ++at_;
    if (text_.substr(at_, 3) != "...") return;
    at_ = std::min(text_.find('\n', at_), text_.size());
    if (at_ < text_.size()) ++at_;
    skip();
  }
  bool take(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  /// True where a blank ends an element: [1 -2] has two.
  bool ends_element() {
    if (!in_matrix_) return false;
    const std::size_t start = at_;
    skip();
    const bool had_blank = at_ > start;
    const bool is_sign = peek() == '+' || peek() == '-';
    const bool ends = had_blank && is_sign && !is_blank(peek(1));
    if (ends) at_ = start;
    return ends;
  }

  Value range() {
    const Depth depth(*this);
    const Value first = sum();
    skip_inside();
    if (peek() != ':') return first;
    ++at_;
    Value second = sum();
    skip_inside();
    if (peek() != ':') return range_of(first.number(), 1.0, second.number());
    ++at_;
    return range_of(first.number(), second.number(), sum().number());
  }

  static Value range_of(double from, double by, double to) {
    const double count = by == 0.0 ? 0.0 : std::floor((to - from) / by * (1.0 + 1e-15) + 1e-10) + 1.0;
    if (!(count < 1e6)) fail("has more than 1,000,000 numbers");
    Value value = Value::matrix(1, static_cast<std::size_t>(std::max(count, 0.0)), 0.0);
    for (std::size_t i = 0; i < value.columns; ++i)
      value.cells[i].number = from + by * static_cast<double>(i);
    return value;
  }

  void skip_inside() {
    if (!in_matrix_) skip();
  }

  Value sum() {
    Value left = terms();
    while (!ends_element()) {
      skip_inside();
      const char op = peek();
      if (op != '+' && op != '-') break;
      ++at_;
      left = each(op, left, terms());
    }
    return left;
  }

  Value terms() {
    Value left = sign();
    for (;;) {
      const std::size_t start = at_;
      skip();
      const bool by_element = peek() == '.' && (peek(1) == '*' || peek(1) == '/');
      const char op = peek(by_element ? 1 : 0);
      if (op != '*' && op != '/') {
        at_ = start;
        return left;
      }
      at_ += by_element ? 2 : 1;
      const Value right = sign();
      if (op == '/' && !by_element && !right.is_scalar()) fail("divides by a matrix");
      left = op == '/' || by_element ? each(op, left, right) : product(left, right);
    }
  }

  Value sign() {
    const Depth depth(*this);
    skip();
    if (take("-")) return negated(sign());
    if (take("+")) return sign();
    return power();
  }

  Value power() {
    Value left = postfix();
    for (;;) {
      const std::size_t start = at_;
      skip();
      const bool by_element = take(".^");
      if (!by_element && !take("^")) {
        at_ = start;
        return left;
      }
      skip();
      Value right = exponent();
      if (!by_element && !left.is_scalar()) fail("has a power of a matrix");
      left = each('^', left, right);
    }
  }

  /// Reads an exponent with its signs: 2^-1.
  Value exponent() {
    const Depth depth(*this);
    skip();
    if (take("-")) return negated(exponent());
    return take("+") ? exponent() : postfix();
  }

  static Value negated(const Value& value) {
    Value result = value;
    result.name.clear();
    for (Cell& cell : result.cells) {
      const std::string inner = cell.strength < 2 ? "(" + cell.text + ")" : cell.text;
      cell = cell.text.empty() ? Cell{-cell.number} : Cell{-cell.number, "-" + inner, 3};
    }
    return result;
  }

  Value postfix() {
    Value value = primary();
    while (peek() == '\'' || (peek() == '.' && peek(1) == '\'')) {
      at_ += peek() == '.' ? 2 : 1;
      value = transposed(value);
    }
    return value;
  }

  Value primary() {
    const Depth depth(*this);
    skip();
    const char c = peek();
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return number();
    if (is_letter(c)) return named();
    if (c == '(') return in_round();
    if (c == '[') return matrix();
    if (c == '\'' || c == '"') fail("is a text, and numbers are expected");
    if (c == '\0') fail("is empty or ends too early");
    fail(fmt::format("has '{}', which is not evaluated", c));
  }

  Value number() {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("has a number that cannot be read");
    at_ = static_cast<std::size_t>(end - text_.data());
    const bool is_elementwise = text_[at_ - 1] == '.' && (peek() == '*' || peek() == '/' || peek() == '^');
    if (is_elementwise) --at_;  // 1./x is 1 ./ x
    if (peek() == 'i' || peek() == 'j') fail("is complex");
    return Value::of(value);
  }

  Value in_round() {
    ++at_;
    const bool outer = std::exchange(in_matrix_, false);
    Value value = range();
    skip();
    if (!take(")")) fail("has '(' without ')'");
    in_matrix_ = outer;
    value.name.clear();
    return value;
  }

  Value named() {
    std::string name;
    while (is_letter(peek()) || is_digit(peek()) || (peek() == '.' && is_letter(peek(1))))
      name += text_[at_++];
    std::vector<Value> arguments;
    const bool has_arguments = peek() == '(';
    if (has_arguments) arguments = list();
    const bool can_be_called = is_function(name, arguments.size());
    const Value value = variables_(name, can_be_called);
    if (can_be_called && value.is_missing) return called(name, arguments);
    return has_arguments ? indexed(value, arguments) : value;
  }

  /// Reads the index of all rows or columns.
  Value whole_dimension() {
    ++at_;
    return {0, 0, {}, ":"};
  }

  std::vector<Value> list() {
    ++at_;
    const bool outer = std::exchange(in_matrix_, false);
    std::vector<Value> values;
    skip();
    while (!take(")")) {
      values.push_back(peek() == ':' ? whole_dimension() : range());
      skip();
      if (!take(",") && peek() != ')') fail("has '(' without ')'");
    }
    in_matrix_ = outer;
    return values;
  }

  Value matrix() {
    ++at_;
    const bool outer = std::exchange(in_matrix_, true);
    ++brackets_;
    std::vector<Value> rows;
    for (bool open = true; open;) {
      Value row = matrix_row();
      if (!row.cells.empty()) rows.push_back(std::move(row));
      if (take("]"))
        open = false;
      else if (!take(";") && !take("\n") && !take("\r"))
        fail("has '[' without ']'");
    }
    --brackets_;
    in_matrix_ = outer;
    return stacked(rows);
  }

  Value matrix_row() {
    Value row{0, 0, {}};
    for (;;) {
      skip();
      while (take(",")) skip();
      if (peek() == ']' || peek() == ';' || peek() == '\n' || peek() == '\r' || peek() == '\0') return row;
      row = beside(row, range());
    }
  }

  std::string_view text_;
  const Variables& variables_;
  std::size_t at_ = 0;
  int depth_ = 0, brackets_ = 0;
  bool in_matrix_ = false;
};

/// Returns a statement without a comment.
std::string without_comment(const std::string& line) {
  return line.substr(0, line.find('%'));
}

bool is_variable(const std::string& text) {
  if (text.empty() || !is_letter(text[0])) return false;
  for (const char c : text)
    if (!is_letter(c) && !is_digit(c) && c != '.') return false;
  return true;
}

/// Splits a script at line ends and semicolons outside of brackets.
std::vector<std::string> statements_of(const std::string& script) {
  std::vector<std::string> statements(1);
  int depth = 0;
  for (const std::string& line : parts_of(script, '\n')) {
    for (const char c : without_comment(line) + "\n") {
      if (c == '[' || c == '(' || c == '{') ++depth;
      if (c == ']' || c == ')' || c == '}') --depth;
      if (depth <= 0 && (c == ';' || c == '\n'))
        statements.emplace_back();
      else
        statements.back() += c;
    }
  }
  return statements;
}

}  // namespace

Value evaluated(std::string_view text, const Variables& variables) {
  if (text.size() > max_length) throw ValueError("is longer than 1,000,000 characters");
  return Parser(text, variables).run();
}

std::vector<Assignment> assignments_of(const std::string& script, std::vector<std::string>& others) {
  std::vector<Assignment> found;
  for (const std::string& statement : statements_of(script)) {
    const std::string text = on_one_line(statement);
    if (text.empty() || text == "clear" || text == "clc" || text == "close all" || text == "clear all")
      continue;
    const std::size_t sign = statement.find('=');
    const std::string name = on_one_line(statement.substr(0, sign));
    const bool is_assignment =
        sign != statement.npos && statement.substr(sign, 2) != "==" && is_variable(name);
    if (is_assignment)
      found.push_back({name, statement.substr(sign + 1)});
    else
      others.push_back(text);
  }
  return found;
}

}  // namespace stepwire::simulink

#include "engine/base/expression/token.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "engine/base/expression/expression.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::expression {
namespace {

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

}  // namespace

std::vector<Token> tokens(std::string_view text, const Known& known) {
  Lexer lexer(text, known);
  std::vector<Token> result;
  do result.push_back(lexer.next());
  while (result.back().kind != Token::Kind::end);
  return result;
}

}  // namespace stepwire::expression

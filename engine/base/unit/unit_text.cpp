#include <charconv>
#include <cmath>

#include "engine/base/unit/named_unit.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {
namespace {

constexpr std::size_t longest_unit = 200;
constexpr int deepest = 8;
constexpr double largest_exponent = 20.0;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// True for letters and all bytes beyond ASCII, since "µ", "°" and "Ω" are several bytes long.
bool starts_word(char c) {
  const char lower = static_cast<char>(c | 0x20);
  return (lower >= 'a' && lower <= 'z') || c == '_' || c == '%' ||
         (static_cast<unsigned char>(c) & 0x80) != 0;
}

Unit raised(const Unit& unit, double exponent) {
  return {std::pow(unit.scale, static_cast<long double>(exponent)), 0.0L, power(unit.dimension, exponent)};
}

bool usable(const Unit& unit) {
  return std::isfinite(unit.scale) && unit.scale > 0.0L;
}

/// True where the word continues at `at`, so that the unit before is only its start: "s" of "s.x" or of
/// "sin".
bool name_goes_on(std::string_view text, std::size_t at) {
  if (at >= text.size()) return false;
  if (starts_word(text[at]) || is_digit(text[at]) || text[at] == '(') return true;
  return text[at] == '.' && at + 1 < text.size() && starts_word(text[at + 1]);
}

using Taken = std::function<bool(std::string_view)>;

/// Parser of the longest prefix that is a unit; `end` is the end of the last complete unit.
class Reader {
 public:
  /// `taken` selects parsing inside an expression: no blanks, no "s-1" (a difference there), no partial
  /// names.
  explicit Reader(std::string_view text, const Taken* taken = nullptr) : text_(text), taken_(taken) {}

  std::optional<Unit> product(int depth) {
    auto result = at_one() ? one() : factor(depth, false);
    std::optional<Unit> complete;
    std::size_t complete_at = at_;
    while (result) {
      if (!taken_ || !name_goes_on(text_, at_)) {
        complete = result;
        complete_at = at_;
      }
      const char sign = operation();
      const auto next = sign ? factor(depth, true) : std::nullopt;
      result = next ? std::optional(joined(*result, sign, *next)) : std::nullopt;
    }
    at_ = complete_at;
    return complete;
  }

  std::size_t end() const { return at_; }

 private:
  static Unit joined(const Unit& a, char sign, const Unit& b) {
    if (sign == '/') return {a.scale / b.scale, 0.0L, a.dimension / b.dimension};
    return {a.scale * b.scale, 0.0L, a.dimension * b.dimension};
  }

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  /// True for a bare 1, which may start a unit as in "1/s"; a unit contains no other number.
  bool at_one() const { return peek() == '1' && (peek(1) == '/' || (!taken_ && text_ == "1")); }

  std::optional<Unit> one() {
    ++at_;
    return Unit{};
  }

  void skip_blanks() {
    while (!taken_ && peek() == ' ') ++at_;
  }

  char operation() {
    const std::size_t before = at_;
    skip_blanks();
    const char c = peek();
    if (c == '.' || c == '*' || c == '/') {
      ++at_;
      skip_blanks();
      return c;
    }
    return at_ > before ? ' ' : '\0';
  }

  std::optional<Unit> factor(int depth, bool later) {
    if (peek() == '(') return depth < deepest ? parenthesis(depth) : std::nullopt;
    const std::size_t first = at_;
    const std::string_view name = word();
    if (name.empty() || (later && is_taken(first))) return std::nullopt;
    const auto unit = named_unit(name);
    return unit ? with_exponent(*unit) : std::nullopt;
  }

  std::optional<Unit> parenthesis(int depth) {
    ++at_;
    skip_blanks();
    const auto result = product(depth + 1);
    skip_blanks();
    if (!result || peek() != ')') return std::nullopt;
    ++at_;
    return with_exponent(*result);
  }

  std::string_view word() {
    const std::size_t first = at_;
    if (!starts_word(peek())) return {};
    while (starts_word(peek()) || is_digit(peek())) ++at_;
    return text_.substr(first, at_ - first);
  }

  /// Parses the exponent of a unit: "m^2", "m^-0.5", "s-1".
  std::optional<Unit> with_exponent(const Unit& unit) {
    const bool hat = peek() == '^';
    if (!hat && (taken_ || peek() != '-')) return unit;
    double exponent = 0.0;
    const char* const first = text_.data() + at_ + (hat ? 1 : 0);
    auto [rest, error] =
        std::from_chars(first, text_.data() + text_.size(), exponent, std::chars_format::fixed);
    if (error != std::errc{} || exponent == 0.0 || !(std::abs(exponent) <= largest_exponent)) return unit;
    if (rest[-1] == '.') --rest;  // "m^2.s"
    at_ = static_cast<std::size_t>(rest - text_.data());
    return raised(unit, exponent);
  }

  /// True where the name that starts at `first`, with or without its dotted continuation, is taken.
  bool is_taken(std::size_t first) const {
    if (!taken_ || !*taken_) return false;
    std::size_t end = at_;
    if ((*taken_)(text_.substr(first, end - first))) return true;
    while (end < text_.size() && (text_[end] == '.' || starts_word(text_[end]) || is_digit(text_[end])))
      ++end;
    return (*taken_)(text_.substr(first, end - first));
  }

  std::string_view text_;
  const Taken* taken_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (text.empty()) return Unit{};
  if (text.size() > longest_unit) return std::nullopt;
  Reader reader(text);
  const auto unit = reader.product(0);
  if (!unit || reader.end() != text.size() || !usable(*unit)) return std::nullopt;
  return unit;
}

std::size_t unit_prefix(std::string_view text, const Taken& taken) {
  Reader reader(text.substr(0, longest_unit), &taken);
  const auto unit = reader.product(0);
  return unit && usable(*unit) ? reader.end() : 0;
}

}  // namespace stepwire::unit

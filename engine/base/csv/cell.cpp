#include "engine/base/csv/cell.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "engine/base/text/characters.hpp"

namespace stepwire::csv {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool are_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

/// Parts of a number: a sign, digits with marks, and an exponent.
struct Pieces {
  std::string sign, digits, exponent;
  bool grouped = false;  ///< by separators that are never decimal marks
};

/// Returns the length of an exponent (letter, sign and digits) at the end of `text`; 0 without one. Fortran
/// omits the letter before three digits.
std::size_t exponent_length(std::string_view text) {
  std::size_t first = text.size();
  while (first > 0 && is_digit(text[first - 1])) --first;
  const std::size_t count = text.size() - first;
  if (count == 0 || first == 0) return 0;
  const bool sign = text[first - 1] == '+' || text[first - 1] == '-';
  const std::size_t letter = first - (sign ? 1 : 0);
  if (letter > 0 && std::string_view("eEdD").find(text[letter - 1]) != std::string_view::npos)
    return text.size() - letter + 1;
  const bool mark = text.find_first_of(",.") != std::string_view::npos;
  return sign && letter > 0 && count == 3 && mark ? text.size() - letter : 0;
}

/// True for one to three digits followed by groups of three behind marks: "1,234,567". The first group must
/// not begin with 0.
bool is_grouped(std::string_view digits, char mark) {
  const std::size_t first = digits.find(mark);
  if (first == std::string_view::npos || first == 0 || first > 3 || digits.front() == '0') return false;
  if (!are_digits(digits.substr(0, first))) return false;
  for (std::size_t at = first; at < digits.size(); at += 4)
    if (digits[at] != mark || digits.size() - at < 4 || !are_digits(digits.substr(at + 1, 3))) return false;
  return true;
}

/// Removes apostrophes and narrow or non-breaking spaces between groups; these are never decimal marks.
bool take_out_groups(std::string& digits) {
  std::string marked = digits;
  for (const char* mark : {"\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x99"}) text::replace_all(marked, mark, "'");
  const std::size_t end = std::min(marked.find_first_of(",."), marked.size());
  if (!is_grouped(std::string_view(marked).substr(0, end), '\'')) return false;
  std::erase(marked, '\'');
  digits = marked;
  return true;
}

Pieces pieces_of(std::string text_of_cell) {
  text::replace_all(text_of_cell, "\xE2\x88\x92", "-");  // the minus sign of typography
  std::string_view text = text_of_cell;
  Pieces pieces;
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
    if (text.front() == '-') pieces.sign = "-";
    text.remove_prefix(1);
  }
  const std::size_t length = exponent_length(text);
  pieces.exponent = text.substr(text.size() - length);
  pieces.digits = text.substr(0, text.size() - length);
  pieces.grouped = take_out_groups(pieces.digits);
  return pieces;
}

/// Classifies a number with both marks: the last mark is decimal, the others separate thousands.
Shape shape_of_both(std::string_view digits) {
  const std::size_t last = digits.find_last_of(",.");
  const char group = digits[last] == ',' ? '.' : ',';
  const std::string_view fraction = digits.substr(last + 1);
  if (!is_grouped(digits.substr(0, last), group) || !(fraction.empty() || are_digits(fraction)))
    return Shape::other;
  return group == '.' ? Shape::grouped_comma : Shape::grouped_point;
}

Shape shape_of_pieces(const Pieces& pieces) {
  const std::string& digits = pieces.digits;
  const auto commas = std::ranges::count(digits, ','), points = std::ranges::count(digits, '.');
  const bool numeric =
      std::ranges::all_of(digits, [](char c) { return is_digit(c) || c == ',' || c == '.'; });
  if (!numeric || std::ranges::none_of(digits, is_digit)) return Shape::other;
  if (commas == 0 && points == 0) return Shape::plain;
  if (commas > 0 && points > 0) return shape_of_both(digits);
  const bool comma = commas > 0;
  const bool grouped = is_grouped(digits, comma ? ',' : '.');
  if (commas + points > 1)
    return !grouped ? Shape::other : comma ? Shape::grouped_point : Shape::grouped_comma;
  if (grouped && !pieces.grouped && pieces.exponent.empty())
    return comma ? Shape::either_comma : Shape::either_point;
  return comma ? Shape::comma : Shape::point;
}

/// Returns the exponent in C++ syntax: "D+03" and "-104" become "e03" and "e-104".
std::string exponent_text(std::string exponent) {
  if (exponent.empty()) return "";
  if (exponent.front() != '+' && exponent.front() != '-') exponent.erase(0, 1);
  if (exponent.front() == '+') exponent.erase(0, 1);
  return "e" + exponent;
}

}  // namespace

Shape shape_of(const std::string& text) {
  return shape_of_pieces(pieces_of(text));
}

std::optional<CellNumber> cell_number(const std::string& text, Decimal decimal) {
  Pieces pieces = pieces_of(text);
  const Shape shape = shape_of_pieces(pieces);
  const bool comma = decimal == Decimal::comma;
  const bool fits = comma ? shape != Shape::point && shape != Shape::grouped_point
                          : shape != Shape::comma && shape != Shape::grouped_comma;
  if (shape == Shape::other || !fits) return std::nullopt;
  const std::size_t length = pieces.digits.size();
  std::erase(pieces.digits, comma ? '.' : ',');
  const bool grouped = pieces.grouped || pieces.digits.size() != length;
  std::ranges::replace(pieces.digits, ',', '.');
  return CellNumber{pieces.sign + pieces.digits + exponent_text(pieces.exponent), grouped};
}

double rest_of(std::string_view text, double value) {
  constexpr double least = 1e6, most = 1e15;
  const double size = std::abs(value), whole_of_value = std::floor(size);
  if (!(size >= least && size < most) || size == whole_of_value) return 0.0;
  while (!text.empty() && !is_digit(text.front())) text.remove_prefix(1);
  const char* const end = text.data() + text.size();
  std::int64_t whole = 0;
  const auto [mark, error] = std::from_chars(text.data(), end, whole);
  double fraction = 0.0;
  if (error != std::errc{} || mark == end || *mark != '.') return 0.0;
  const auto [rest, wrong] = std::from_chars(mark, end, fraction, std::chars_format::fixed);
  if (wrong != std::errc{} || (rest != end && *rest != ' ' && *rest != '\t')) return 0.0;
  const double missing = static_cast<double>(whole - static_cast<std::int64_t>(whole_of_value)) +
                         (fraction - (size - whole_of_value));
  return value < 0.0 ? -missing : missing;
}

std::string with_exponent_letter(const std::string& text) {
  const std::size_t sign = text.find_last_of("+-");
  if (sign == std::string::npos || sign == 0 || !are_digits(std::string_view(text).substr(sign + 1)))
    return "";
  const std::string mantissa = text.substr(0, sign);
  const bool has_mark = mantissa.find_first_of(",.") != std::string::npos && is_digit(mantissa.back());
  const std::string meant = mantissa + "e" + text.substr(sign);
  return has_mark && shape_of(text) == Shape::other && shape_of(meant) != Shape::other ? meant : "";
}

bool is_missing(const std::string& text) {
  static constexpr std::array<std::string_view, 8> words{"",     "nan",  "na",   "n/a",
                                                         "#n/a", "null", "none", "<na>"};
  std::string_view word = text;
  if (word == "-nan" || word == "+nan" || word == "-NaN") word.remove_prefix(1);
  return std::ranges::any_of(words, [&](std::string_view one) {
    return std::ranges::equal(one, word, {}, {}, [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
  });
}

}  // namespace stepwire::csv

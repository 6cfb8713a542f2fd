#include "engine/base/table/csv_cell.hpp"

#include <algorithm>
#include <charconv>

namespace stepwire {
namespace {

/// Of a decimal number with an exponent: is it 1 or above? Digits and exponent may be too many for any type.
bool is_large(std::string_view text) {
  const std::size_t digits = text.find_first_not_of("+-0.");
  if (digits == std::string_view::npos) return false;
  const std::size_t exponent = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min({text.find('.'), exponent});
  const double before = static_cast<double>(point) - static_cast<double>(digits);  // digits before the point
  std::string_view power = text.substr(std::min(exponent + 1, text.size()));
  const bool negative = power.starts_with('-');
  if (negative || power.starts_with('+')) power.remove_prefix(1);
  double shift = 0.0;
  for (const char digit : power) shift = 10.0 * shift + (digit - '0');
  return before + (negative ? -shift : shift) > 0.0;
}

/// Would a spreadsheet compute this, or this without an apostrophe in front of it? Numbers are what they are.
bool begins_formula(const std::string& word) {
  const std::size_t start = std::min(word.find_first_not_of('\''), word.size());
  if (start == word.size() || std::string_view("=+-@\t\r").find(word[start]) == std::string_view::npos)
    return false;
  return start > 0 || !csv_number(word);
}

}  // namespace

std::optional<double> csv_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const char* const end = text.data() + text.size();
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (rest != end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc{}) return value;
  if (is_large(text)) return std::nullopt;
  return text.starts_with('-') ? -0.0 : 0.0;
}

std::string csv_cell(const std::string& word) {
  return begins_formula(word) ? "'" + word : word;
}

std::string csv_word(const std::string& cell) {
  return cell.starts_with('\'') && csv_cell(cell.substr(1)) == cell ? cell.substr(1) : cell;
}

}  // namespace stepwire

#include "engine/base/table/csv_cell.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace stepwire::table {
namespace {

/// True for a word that a spreadsheet takes for a formula, with or without a leading apostrophe; numbers are
/// exempt.
bool begins_formula(const std::string& word) {
  const std::size_t start = std::min(word.find_first_not_of('\''), word.size());
  if (start == word.size() || std::string_view("=+-@\t\r").find(word[start]) == std::string_view::npos)
    return false;
  return start > 0 || !csv_number(word);
}

/// Parses a number that fills the whole text.
std::errc read_number(std::string_view text, double& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return rest == end ? error : std::errc::invalid_argument;
}

}  // namespace

std::optional<double> csv_number(std::string_view text) {
  double value = 0.0;
  if (read_number(text, value) != std::errc{}) return std::nullopt;
  return value;
}

std::string csv_number_problem(const std::string& text) {
  double value = 0.0;
  if (read_number(text, value) != std::errc::result_out_of_range) return "is no number";
  return std::abs(std::strtod(text.c_str(), nullptr)) > 1.0 ? "is too large: numbers are below 1.8e308"
                                                            : "is too small: numbers are 0 or above 4.9e-324";
}

std::string csv_cell(const std::string& word) {
  return begins_formula(word) ? "'" + word : word;
}

std::string csv_word(const std::string& cell) {
  return cell.starts_with('\'') && csv_cell(cell.substr(1)) == cell ? cell.substr(1) : cell;
}

}  // namespace stepwire::table

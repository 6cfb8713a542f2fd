#pragma once

#include <optional>
#include <string>

namespace stepwire::csv {

/// The mark between whole numbers and fractions in a file; `detect`: that of its numbers.
enum class Decimal { detect, comma, point };

/// Kinds of cells by their marks.
enum class Shape {
  other,          ///< no number of digits: a text, a time, a missing value, infinity
  plain,          ///< no mark at all, 12
  comma,          ///< a decimal comma, 0,2
  point,          ///< a decimal point, 0.2
  grouped_comma,  ///< thousands in points, so that a comma is decimal: 1.234,5 or 1.234.567
  grouped_point,  ///< thousands in commas: 1,234.5 or 1,234,567
  either_comma,   ///< 1,234 is 1.234 or 1234
  either_point    ///< 1.234 is 1.234 or 1234
};

Shape shape_of(const std::string& text);

/// A cell with its digits as the language of C++ has them.
struct CellNumber {
  std::string text;      ///< without thousands separators, with a decimal point and the exponent 'e'
  bool grouped = false;  ///< it has thousands separators
};

/// A number of digits under a decimal mark, with exponents of Fortran (1.0D+03, 1.0-104) and of C. Empty for
/// other texts, also for a number with the other decimal mark.
std::optional<CellNumber> cell_number(const std::string& text, Decimal decimal);

/// True for an empty cell and the words of other programs for one: NaN, NA, N/A, #N/A, null, None.
bool is_missing(const std::string& text);

}  // namespace stepwire::csv

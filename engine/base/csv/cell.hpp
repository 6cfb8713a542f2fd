#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stepwire::csv {

/// Decimal mark of a file; `detect` infers it from the numbers of the file.
enum class Decimal { detect, comma, point };

/// Kinds of cells, classified by their marks.
enum class Shape {
  other,          ///< Without digits: a text, a time, a missing value, infinity.
  plain,          ///< No mark at all: 12.
  comma,          ///< A decimal comma: 0,2.
  point,          ///< A decimal point: 0.2.
  grouped_comma,  ///< Thousands in points, so that a comma is decimal: 1.234,5 or 1.234.567.
  grouped_point,  ///< Thousands in commas: 1,234.5 or 1,234,567.
  either_comma,   ///< Ambiguous: 1,234 is 1.234 or 1234.
  either_point    ///< Ambiguous: 1.234 is 1.234 or 1234.
};

Shape shape_of(const std::string& text);

/// Number of a cell in C++ syntax.
struct CellNumber {
  std::string text;      ///< without thousands separators, with a decimal point and the exponent 'e'
  bool grouped = false;  ///< it has thousands separators
};

/// Parses a number under a decimal mark, with exponents of Fortran (1.0D+03, 1.0-104) or C. Returns
/// std::nullopt for other texts and for a number with the other decimal mark.
std::optional<CellNumber> cell_number(const std::string& text, Decimal decimal);

/// Returns the exact number of a text of digits with a decimal point minus its double `value`. Returns 0 for
/// other texts, whole numbers and values below a million, whose rounding moves no row.
double rest_of(std::string_view text, double value);

/// Returns a number whose exponent of one or two digits lacks its letter with an 'e': "1.0e+3" for "1.0+3",
/// which may also be two numbers. Empty for other texts.
std::string with_exponent_letter(const std::string& text);

/// True for an empty cell and for the usual words for a missing value: NaN, NA, N/A, #N/A, null, None.
bool is_missing(const std::string& text);

}  // namespace stepwire::csv

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stepwire::table {

/// Parses a number that fills the whole text. Returns std::nullopt for other texts and for numbers out of the
/// range of a double.
std::optional<double> csv_number(std::string_view text);

/// Returns the reason why csv_number() fails: "is no number", or too large or too small.
std::string csv_number_problem(const std::string& text);

/// Encodes a word for a cell. A word that a spreadsheet takes for a formula gets an apostrophe in front: it
/// begins with = + - @ or a control character and is not a number. So does a word that already begins with
/// apostrophes followed by such a text.
std::string csv_cell(const std::string& word);

/// Decodes the word of a cell; the inverse of csv_cell().
std::string csv_word(const std::string& cell);

}  // namespace stepwire::table

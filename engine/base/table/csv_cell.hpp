#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stepwire::table {

/// A number that fills the whole text; nothing for what is too large or too small to be a double.
std::optional<double> csv_number(std::string_view text);

/// Why a text is none: "is no number", or that it is too large or too small for one.
std::string csv_number_problem(const std::string& text);

/// A word as it stands in a cell: one that a spreadsheet would take for a formula, since it begins with = + -
/// @ or a control character and is no number, has an apostrophe in front of it, and so has one that begins
/// with apostrophes and goes on like that.
std::string csv_cell(const std::string& word);

/// The word of such a cell.
std::string csv_word(const std::string& cell);

}  // namespace stepwire::table

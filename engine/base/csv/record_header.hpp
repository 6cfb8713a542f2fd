#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/table/csv_lines.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::csv {

/// True for a number with any decimal mark and for a time of the calendar.
bool is_value(const std::string& text);

/// Splits a title into name and unit: "x [mm]", or "x (mm)" where the text in parentheses is a unit.
table::Column titled_column(const std::string& title);

/// Returns the columns of a header; a column without a name keeps its position. Columns of the same name with
/// different units are named by their whole titles. Fails for a line of numbers only and for a duplicate
/// name.
std::vector<table::Column> columns_of(const std::vector<std::string>& titles, const table::CsvLines& lines);

/// Returns the units in the row below the names, as in `s;mm;N`; std::nullopt for a row of values. A row of
/// units has no number but 1, and has units above the values of columns. If it has at least as many ones as
/// such units, one of these must be a time.
std::optional<std::vector<std::string>> units_below(const std::vector<std::string>& row,
                                                    const std::vector<std::string>& next_row);

}  // namespace stepwire::csv

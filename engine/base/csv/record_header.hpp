#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/table/csv_lines.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::csv {

/// True for a number of digits, whatever its decimal mark, and for a time of the calendar.
bool is_value(const std::string& text);

/// Name and unit of a title: "x [mm]", or "x (mm)" where the text in parentheses is a unit.
table::Column titled_column(const std::string& title);

/// The columns of a header; one without a name keeps its place. Where two have the same name beside different
/// units, their names are the whole titles. Fails where the line has numbers only, or a name twice.
std::vector<table::Column> columns_of(const std::vector<std::string>& titles, const table::CsvLines& lines);

/// The units in the row below the names, as in `s;mm;N`; empty for a row of values. It is a row of
/// units where it has no number but 1, and a unit above the values of a column; beside as many ones, one of
/// time.
std::optional<std::vector<std::string>> units_below(const std::vector<std::string>& row,
                                                    const std::vector<std::string>& next_row);

}  // namespace stepwire::csv

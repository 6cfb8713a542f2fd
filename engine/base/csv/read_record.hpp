#pragma once

#include <string>

#include "engine/base/csv/cell.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::csv {

/// A CSV file as other programs and people leave it: the encodings of decode(); comma, semicolon, tab or
/// blanks between the columns; lines that begin with '#'; units in the header or below it; the decimal mark
/// that is given or that the numbers prove; times of the calendar. A missing value is nan. A column with
/// another cell that is no number is a problem, with the first such cell. Columns without a name, as that of
/// trailing commas, and empty rows at the end are left out. Throws TableError with file and row for rows of
/// another length, double names and no rows, and EnvironmentError where the file cannot be read.
table::RecordTable read_record(const std::string& path, Decimal decimal = Decimal::detect);

}  // namespace stepwire::csv

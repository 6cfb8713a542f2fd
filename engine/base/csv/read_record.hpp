#pragma once

#include <string>

#include "engine/base/csv/cell.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::csv {

/// Reads a CSV file as other programs and people write it. Encodings are those of decode(). Commas,
/// semicolons, tabs or blanks separate columns; lines that begin with '#' are comments. Units are in the
/// header or below it; columns may hold times of the calendar. The decimal mark is given, or inferred from
/// the numbers.
///
/// A missing value is NaN. A column with a cell that is not a number becomes a problem that names the first
/// such cell. Columns without a name and empty rows at the end are left out. Throws TableError, with file and
/// row, for rows of different lengths, duplicate names and no rows. Throws EnvironmentError for an unreadable
/// file.
table::RecordTable read_record(const std::string& path, Decimal decimal = Decimal::detect);

}  // namespace stepwire::csv

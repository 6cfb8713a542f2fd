#pragma once

#include <string>

#include "engine/base/csv/cell.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::csv {

/// Reads a CSV file as other programs and people leave it:
///  - in the encodings of decode(),
///  - with commas, semicolons, tabs or blanks between the columns, and lines that begin with '#',
///  - with units in the header or below it, and times of the calendar,
///  - with the given decimal mark, or the one that the numbers prove.
/// A missing value is nan. A column with another cell that is no number is a problem, with the first such
/// cell. Columns without a name and empty rows at the end are left out. Throws TableError with file and row
/// for rows of another length, double names and no rows. Throws EnvironmentError for a file that cannot be
/// read.
table::RecordTable read_record(const std::string& path, Decimal decimal = Decimal::detect);

}  // namespace stepwire::csv

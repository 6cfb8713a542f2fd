#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/csv/cell.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::csv {

/// Reads a CSV file as other programs and people write it. Encodings are those of decode(). Commas,
/// semicolons, tabs or blanks separate columns; lines that begin with '#' are comments. Blank lines between
/// rows of several columns are skipped. Units are in the
/// header or below it; columns may hold times of the calendar. The decimal mark is given, or inferred from
/// the numbers.
///
/// A missing value is NaN. A column with a cell that is not a number becomes a problem that names the first
/// such cell. Columns without a name and empty rows at the end are left out. Throws TableError, with file and
/// row, for rows of different lengths, duplicate names and no rows. Throws EnvironmentError for an unreadable
/// file.
table::RecordTable read_record(const std::string& path, Decimal decimal = Decimal::detect);

/// A table whose cells are texts.
struct TextColumns {
  std::vector<table::Column> columns;           ///< names and units, without values
  std::vector<std::vector<std::string>> cells;  ///< of each column, by row
  std::vector<std::size_t> lines;               ///< of each row in the file
};

/// Reads a CSV file as read_record() does, without conversion of its cells. It may have no rows.
TextColumns read_texts(const std::string& path);

}  // namespace stepwire::csv

#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/io/file.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::table {

/// What is wrong in a data file that a user gave: "press.csv:17: 'abc' is no number".
class TableError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How many bytes a data file of `file_size` may unpack to: a small one that unpacks to gigabytes is no
/// record.
constexpr std::size_t max_unpacked(std::size_t file_size) {
  return (std::size_t{64} << 20) + 20 * file_size;
}

/// Words that the numbers 0, 1, ... of a column stand for, by the column's name.
using ColumnWords = std::map<std::string, std::vector<std::string>>;

/// A CSV file with a header line: comma, semicolon or tab; the unit of a column from "name [unit]" or none.
/// Quoted fields, CRLF, a byte-order mark and an empty last line are accepted. Throws TableError with file
/// and row for rows of another length, what is no number, double names, no rows; EnvironmentError where the
/// file cannot be read.
Table read_csv(const std::string& path);

/// A CSV file that this program wrote. It may have no rows, and the columns that `words` names hold words:
/// these are numbered in the order in which they come up, and are then in `words`.
Table read_csv(const std::string& path, ColumnWords& words);

/// Its columns alone, without values.
Table read_csv_header(const std::string& path);

/// Comma, header "name [unit]", numbers in the shortest form that reads back to the same bits; nan and inf as
/// such; words where a column has them. Throws TableError for columns of different lengths.
std::string csv_text(const Table& table, const ColumnWords& words = {});

/// The pieces of such a text, for a file that grows: its first line, with names and units of columns, and one
/// number or word of a row.
void append_csv_head(std::string& text, const std::vector<Column>& columns);
void append_csv_number(std::string& text, double value);
void append_csv_word(std::string& text, const std::string& word);

/// Writes the text of the table as write_file() does; that of a large one piece by piece.
void write_csv(const std::string& path, const Table& table, const ColumnWords& words = {});

}  // namespace stepwire::table

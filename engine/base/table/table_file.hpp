#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/io/file.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::table {

/// Thrown for an invalid data file of the user: "press.csv:17: 'abc' is no number".
class TableError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the most bytes that a data file of `file_size` may unpack to. A larger ratio indicates a malicious
/// file.
constexpr std::size_t max_unpacked(std::size_t file_size) {
  return (std::size_t{64} << 20) + 20 * file_size;
}

/// Words coded by the numbers 0, 1, ... of a column, by column name.
using ColumnWords = std::map<std::string, std::vector<std::string>>;

/// Reads a CSV file with a header line. The separator is comma, semicolon or tab; "name [unit]" gives a
/// column its unit. Quoted fields, CRLF, a byte-order mark and an empty last line are accepted. Throws
/// TableError, with file and row, for rows of different lengths, invalid numbers, duplicate names and no
/// rows. Throws EnvironmentError for an unreadable file.
Table read_csv(const std::string& path);

/// Reads a CSV file that this program wrote; it may have no rows. Columns that `words` names hold words. They
/// are numbered in order of appearance and stored in `words`.
Table read_csv(const std::string& path, ColumnWords& words);

/// Reads the columns without values.
Table read_csv_header(const std::string& path);

/// Writes CSV: commas, header "name [unit]", and numbers in the shortest form that reads back to the same
/// bits. NaN is "nan" and infinity "inf"; columns with words have these. Throws TableError for columns of
/// different lengths.
std::string csv_text(const Table& table, const ColumnWords& words = {});

/// Append the parts of such a text to a growing file: the header line, and one number or word of a row.
void append_csv_head(std::string& text, const std::vector<Column>& columns);
void append_csv_number(std::string& text, double value);
void append_csv_word(std::string& text, const std::string& word);

/// Writes the table as CSV, like write_file(); large tables are written in pieces.
void write_csv(const std::string& path, const Table& table, const ColumnWords& words = {});

}  // namespace stepwire::table

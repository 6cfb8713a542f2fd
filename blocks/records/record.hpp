#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/signal/index.hpp"

namespace stepwire {

inline constexpr unit::Dimension time_dimension{{0.0, 0.0, 1.0}};

/// Column of a record in SI, with its dimension if its unit is known.
struct RecordColumn {
  std::string name;
  std::optional<unit::Dimension> dimension;
  std::vector<double> values;
};

/// Columns of a data file over time during their preparation: rows in SI, and the rows of the file that they
/// were taken from.
struct Record {
  std::string file;                   ///< for messages
  std::string time_name;              ///< column with the times, for messages
  double origin = 0.0;                ///< time of the file at which `time` is 0 [s]
  std::vector<double> time;           ///< of each row [s], increasing, with two equal ones at a jump
  std::vector<RecordColumn> columns;  ///< as long as `time` each

  const table::RecordTable* table = nullptr;  ///< the whole file
  std::vector<std::size_t> file_rows;         ///< rows of the table in the record
  std::vector<double> file_times;             ///< of these rows [s]
  bool hold_missing = false;                  ///< true if a missing value is that of the previous row

  Index rows() const { return static_cast<Index>(time.size()); }
  /// Returns the mean time between rows of different times [s]; NaN if all times are equal.
  double interval() const;
};

/// Returns the first row whose time is not that of an even series from the first to the last one. The
/// tolerance is a thousandth of the interval, for the rounding of loggers. Returns std::nullopt for even
/// rows.
std::optional<Index> first_uneven(std::span<const double> time);

/// Returns the place of a number for messages: "press.csv:17: x" for a text file, else "press.mat: element 16
/// of x".
std::string place_in_file(const std::string& file, const table::RecordTable& table, const std::string& column,
                          std::size_t row);

/// Returns the first of these rows without a value in a column.
std::optional<std::size_t> first_missing(const std::vector<double>& values,
                                         const std::vector<std::size_t>& rows);

/// Returns the message for a missing value, with its place.
std::string missing_value(const Record& record, const std::string& column, std::size_t row);

/// Returns the values of a column in these rows. With `hold`, a missing one is that of the previous row, if
/// there is one.
std::vector<double> values_of_rows(const table::Column& column, const std::vector<std::size_t>& rows,
                                   bool hold);

/// Returns the message for a missing column, with a similar name and the existing ones: "press.csv has no
/// column 'F' ...".
std::string no_column(const std::string& file, const table::Table& table, const std::string& name);

}  // namespace stepwire

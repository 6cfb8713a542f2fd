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

/// One column of a record in SI, and what it is, where its unit is known.
struct RecordColumn {
  std::string name;
  std::optional<unit::Dimension> dimension;
  std::vector<double> values;
};

/// Columns of a data file over time while they are prepared: rows in SI, and the rows of the file that they
/// were taken from.
struct Record {
  std::string file;                   ///< for messages
  std::string time_name;              ///< of the column with the times, for messages
  std::vector<double> time;           ///< of each row [s], increasing, but for two rows at a jump
  std::vector<RecordColumn> columns;  ///< as long as `time` each

  const table::RecordTable* table = nullptr;  ///< the whole file
  std::vector<std::size_t> file_rows;         ///< rows of the table that the record was made of
  std::vector<double> file_times;             ///< of these rows [s]
  bool hold_missing = false;                  ///< a missing value is that of the row before

  Index rows() const { return static_cast<Index>(time.size()); }
  /// Mean time between rows of different times [s]; nan where all have one.
  double interval() const;
};

/// First row whose time is not that of an even series from the first to the last one: off by more than a
/// thousandth of the interval, which is the rounding of a logger. Nothing where the rows are even.
std::optional<Index> first_uneven(std::span<const double> time);

/// Place of a number for messages: "press.csv:17: x" of a text file, else "press.mat: element 16 of x".
std::string place_in_file(const std::string& file, const table::RecordTable& table, const std::string& column,
                          std::size_t row);

/// First of these rows without a value in a column.
std::optional<std::size_t> first_missing(const std::vector<double>& values,
                                         const std::vector<std::size_t>& rows);

/// The message for a value that is missing still, with its place.
std::string missing_value(const Record& record, const std::string& column, std::size_t row);

/// Values of a column in these rows; `hold`: a missing one is that of the row before, where there is one.
std::vector<double> values_of_rows(const table::Column& column, const std::vector<std::size_t>& rows,
                                   bool hold);

/// What to tell where a file has no such column: "press.csv has no column 'F'; did you mean 'F_N'? It has:
/// t_s, F_N".
std::string no_column(const std::string& file, const table::Table& table, const std::string& name);

}  // namespace stepwire

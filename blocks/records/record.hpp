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
  std::vector<double> time;           ///< of each row [s], increasing; two rows or more
  std::vector<RecordColumn> columns;  ///< as long as `time` each

  const table::RecordTable* table = nullptr;  ///< the whole file
  Index first = 0;                            ///< row of the table that was the record's first one
  std::vector<double> file_times;             ///< of the rows from there on that the record was made of [s]

  Index rows() const { return static_cast<Index>(time.size()); }
  /// Mean time between rows [s].
  double interval() const { return (time.back() - time.front()) / static_cast<double>(rows() - 1); }
};

/// First row whose time is not that of an even series from the first to the last one: off by more than a
/// thousandth of the interval, which is the rounding of a logger. Nothing where the rows are even.
std::optional<Index> first_uneven(std::span<const double> time);

/// Where a number stands: "press.csv:17: x" for the 16th row (index 15) below the header,
/// "press.mat: element 16 of x".
std::string place_in_file(const std::string& file, const std::string& column, std::size_t row);

/// What to tell where a file has no such column: "press.csv has no column 'F'; did you mean 'F_N'? It has:
/// t_s, F_N".
std::string no_column(const std::string& file, const table::Table& table, const std::string& name);

}  // namespace stepwire

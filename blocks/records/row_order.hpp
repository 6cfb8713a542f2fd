#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"

namespace stepwire {

/// Fault of the rows of a file, with its place and cure.
class RowsRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Rows and columns requested for a record.
struct RowsAsked {
  std::string file;
  const table::RecordTable& table;
  const table::Column* time;  ///< nullptr: rows are evenly spaced
  std::vector<const table::Column*> columns;
  bool skip_missing = false;  ///< true to skip rows without a time or a value
  bool sort = false;
};

/// Rows of the table in the order of their times, and notes on the changes for the user.
struct RowOrder {
  std::vector<std::size_t> rows;
  std::vector<std::size_t> left_out;  ///< rows with a time that have no value, in the order of the file
  std::vector<std::string> notes;
};

/// Returns the rows in order. Two rows of one time are a jump, the values before it and after it, as in FMI.
/// Throws RowsRefused for a missing time, for decreasing times unless they are to be sorted, and for three
/// rows of one time. Sorting is stable.
RowOrder ordered_rows(const RowsAsked& asked);

}  // namespace stepwire

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"

namespace stepwire {

/// The reason why rows of a file are no record, with its place and cure.
class RowsRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The rows that a record is to be made of.
struct RowsAsked {
  std::string file;
  const table::RecordTable& table;
  const table::Column* time;  ///< nullptr: rows are evenly spaced
  std::vector<const table::Column*> columns;
  bool skip_missing = false;  ///< rows without a time or a value are left out
  bool sort = false;
};

/// Rows of the table in the order of their times, and for people what was done to get them.
struct RowOrder {
  std::vector<std::size_t> rows;
  std::vector<std::string> notes;
};

/// Two rows of one time are a jump, the values before it and after it, as FMI has it. Throws RowsRefused for
/// a missing time, times that decrease where they are not to be sorted, and three rows of one time. Sorting
/// keeps the order of rows with the same time.
RowOrder ordered_rows(const RowsAsked& asked);

}  // namespace stepwire

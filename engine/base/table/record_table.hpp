#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/table/table.hpp"

namespace stepwire::table {

/// From this row on each row is one line below the row before it.
struct RowLine {
  std::size_t row, line;
};

/// A table as other programs and people leave it. A number that is missing is nan.
struct RecordTable : Table {
  std::map<std::string, std::string>
      problems{};  ///< by column: the reason why it cannot be read, with its place
  std::map<std::string, std::vector<std::string>>
      words{};  ///< by column: what its numbers 0, 1, ... stand for, where an HDF5 file says so
  std::vector<RowLine> lines{};      ///< of a text file, by row; empty: the first row is line 2
  std::vector<std::string> notes{};  ///< how the file was read, as "decimal comma"

  /// A column by its whole title, "x [mm]" or "x (mm)"; nullptr where there is none.
  const Column* find_titled(std::string_view title) const;
  /// Line of a row in a text file.
  std::size_t line_of(std::size_t row) const;
};

}  // namespace stepwire::table

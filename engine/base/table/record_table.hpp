#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/table/table.hpp"

namespace stepwire::table {

/// Line number of a row; each following row is one line further, up to the next RowLine.
struct RowLine {
  std::size_t row, line;
};

/// A table as other programs and people write it. A missing number is NaN.
struct RecordTable : Table {
  std::map<std::string, std::string>
      problems{};  ///< By column: the reason why it is unreadable, with its place.
  std::map<std::string, std::vector<std::string>> words{};  ///< By column: words coded by 0, 1, ... (HDF5).
  std::vector<RowLine> lines{};  ///< Of a text file, by row; empty if the first row is line 2.
  /// By column: what the double nearest to a text lacks to its exact number, as in fractions of seconds since
  /// 1970; none for a column of exact or small numbers.
  std::map<std::string, std::vector<double>> rests{};
  std::vector<std::string> notes{};  ///< Conversions on reading, such as "decimal comma".

  /// Returns a column by its whole title, "x [mm]" or "x (mm)"; nullptr if it is missing.
  const Column* find_titled(std::string_view title) const;
  /// Returns the line of a row in a text file.
  std::size_t line_of(std::size_t row) const;
};

}  // namespace stepwire::table

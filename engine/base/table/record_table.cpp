#include "engine/base/table/record_table.hpp"

#include <algorithm>

namespace stepwire::table {

const Column* RecordTable::find_titled(std::string_view title) const {
  const auto is_title_of = [&](const Column& column) {
    const std::string &name = column.name, &unit = column.unit;
    return !unit.empty() && (title == name + " [" + unit + "]" || title == name + " (" + unit + ")" ||
                             title == name + "[" + unit + "]" || title == name + "(" + unit + ")");
  };
  const auto at = std::ranges::find_if(columns, is_title_of);
  return at == columns.end() ? nullptr : &*at;
}

std::size_t RecordTable::line_of(std::size_t row) const {
  const auto behind = std::ranges::upper_bound(lines, row, {}, &RowLine::row);
  if (behind == lines.begin()) return row + 2;
  const RowLine& from = *std::prev(behind);
  return from.line + (row - from.row);
}

}  // namespace stepwire::table

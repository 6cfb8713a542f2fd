#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stepwire::table {

/// A named series of numbers. `unit` is text such as "mm/s"; empty if unknown.
struct Column {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

/// Columns of equal length.
struct Table {
  std::vector<Column> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  const Column* find(std::string_view name) const;
};

}  // namespace stepwire::table

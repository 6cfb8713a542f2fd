#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"

namespace stepwire::table {

/// Cells of a file that are no numbers, the first one of each column.
class CsvProblems {
 public:
  void add(std::size_t row, const std::string& column, std::string text) {
    first_.try_emplace(column, Problem{row, std::move(text)});
  }

  /// Leaves out columns without a name and all rows from `rows` on, and tells the table of the problems
  /// before these.
  void settle(RecordTable& table, std::size_t rows) const {
    std::erase_if(table.columns, [](const Column& column) { return column.name.empty(); });
    for (Column& column : table.columns) column.values.resize(rows);
    for (const auto& [column, problem] : first_)
      if (problem.row < rows) table.problems.emplace(column, problem.text);
  }

 private:
  struct Problem {
    std::size_t row;
    std::string text;
  };
  std::map<std::string, Problem> first_;
};

}  // namespace stepwire::table

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/text/text_table.hpp"
#include "engine/view/plot/figure.hpp"

namespace stepwire::plot {

/// Table in a diagram file: in each line a name, and expressions for the other columns.
struct TableRows {
  struct Line {
    std::string name;
    std::vector<query::Series> cells;
  };

  std::string file;
  yaml::Mark mark;
  std::string title;
  std::vector<std::string> columns;  ///< headings; the first one is that of the names
  std::vector<Line> lines;
  std::optional<query::Formula> where;  ///< selects the row of the cells, the first for which it is true
  std::size_t recording = 0;
};

/// Returns the keys `headings`, `rows` and `where`.
const yaml::Key& table_rows_form();

/// Reads `headings`, `rows`, `where` and `title` of a plot `table`; collects faults.
TableRows read_table_rows(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults);

/// Returns the table with its values. Throws Error if `where` selects no row.
text::TextTable filled(const TableRows& rows, std::span<const record::Recording> recordings);

}  // namespace stepwire::plot

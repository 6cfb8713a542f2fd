#include "engine/app/mcp/recorded_signals.hpp"

#include <vector>

#include "engine/app/mcp/bounded.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/csv_cell.hpp"
#include "engine/base/table/csv_lines.hpp"

namespace stepwire::mcp {

using json::Json;

namespace {

/// Returns the numbers and words of the line at the cursor.
Json row_of(table::CsvLines& lines) {
  Json row = Json::list();
  for (const std::string& cell : lines.fields()) {
    const auto number = table::csv_number(cell);
    row.push(number ? Json(*number) : Json(table::csv_word(cell)));
  }
  return row;
}

}  // namespace

Json recorded_signals(const std::string& file, std::size_t most) {
  const std::string text = io::read_file(file);
  table::CsvLines lines(file, text);
  Json columns = Json::list(), rows = Json::list();
  for (const std::string& title : lines.fields()) columns.push(table::csv_word(title));
  lines.skip_line_end();
  std::vector<table::CsvLines::Place> places;
  for (; !lines.only_blanks_left(); lines.skip_line()) places.push_back(lines.place());
  for (const std::size_t index : even_indices(places.size(), most)) {
    lines.go_to(places[index]);
    rows.push(row_of(lines));
  }
  return Json::object()
      .set("columns", std::move(columns))
      .set("rows", std::move(rows))
      .set("of", places.size());
}

}  // namespace stepwire::mcp

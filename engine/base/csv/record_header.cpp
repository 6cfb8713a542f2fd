#include "engine/base/csv/record_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/base/csv/cell.hpp"
#include "engine/base/csv/time_stamp.hpp"
#include "engine/base/table/csv_cell.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::csv {
namespace {

/// True where a text in parentheses is a unit. The index of x(1) and the t of x(t) are not units.
bool is_unit_in_parentheses(const std::string& unit, bool blank_before) {
  if (unit.empty() || is_value(unit) || (unit == "t" && !blank_before)) return false;
  return unit::parse_unit(unit).has_value();
}

/// Returns the unit of a cell in the row of units: brackets are removed, and a dash means "1".
std::string bare_unit(const std::string& cell) {
  const bool brackets = cell.size() > 2 && ((cell.front() == '[' && cell.back() == ']') ||
                                            (cell.front() == '(' && cell.back() == ')'));
  const std::string bare = brackets ? table::csv_trimmed(cell.substr(1, cell.size() - 2)) : cell;
  return bare == "-" || bare == "--" ? "1" : bare;
}

}  // namespace

bool is_value(const std::string& text) {
  return shape_of(text) != Shape::other || time_stamp(text).has_value();
}

table::Column titled_column(const std::string& title) {
  table::Column column = table::csv_column(title);
  const std::size_t open = title.rfind('(');
  if (!column.unit.empty() || open == std::string::npos || open == 0 || title.back() != ')') return column;
  const std::string unit = table::csv_trimmed(title.substr(open + 1, title.size() - open - 2));
  if (!is_unit_in_parentheses(unit, table::is_csv_blank(title[open - 1]))) return column;
  return {table::csv_trimmed(title.substr(0, open)), unit, {}};
}

std::vector<table::Column> columns_of(const std::vector<std::string>& titles, const table::CsvLines& lines) {
  if (std::ranges::all_of(titles,
                          [](const std::string& title) { return is_missing(title) || is_value(title); }))
    lines.fail("the first line holds numbers; it must name the columns");
  std::vector<table::Column> columns;
  std::map<std::string, int> uses;
  for (const std::string& title : titles) {
    columns.push_back(titled_column(table::csv_word(title)));
    ++uses[columns.back().name];
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::string& name = columns[i].name;
    if (name.empty()) continue;
    if (uses.at(name) > 1) name = table::csv_word(titles[i]);
    if (!names.insert(name).second)
      lines.fail(fmt::format("two columns are named '{}'", table::csv_shown(name)));
  }
  return columns;
}

std::optional<std::vector<std::string>> units_below(const std::vector<std::string>& row,
                                                    const std::vector<std::string>& next_row) {
  std::vector<std::string> units;
  std::size_t above_values = 0, ones = 0;
  bool has_time = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (is_value(row[i]) && row[i] != "1") return std::nullopt;
    units.push_back(is_missing(row[i]) ? "" : bare_unit(row[i]));
    const auto unit = unit::parse_unit(units.back());
    if (row[i] == "1") ++ones;
    if (row[i] == "1" || units.back().empty() || units.back() == "1" || !unit) continue;
    if (i < next_row.size() && is_value(next_row[i])) ++above_values;
    has_time = has_time || unit->dimension == unit::Dimension{{0.0, 0.0, 1.0}};
  }
  const bool found = above_values > 0 && (has_time || ones < above_values);
  return found ? std::optional(units) : std::nullopt;
}

}  // namespace stepwire::csv

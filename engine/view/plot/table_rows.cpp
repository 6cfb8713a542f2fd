#include "engine/view/plot/table_rows.hpp"

#include <fmt/format.h>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/run_rows.hpp"
#include "engine/view/plot/panel_reading.hpp"

namespace stepwire {
namespace {

/// Reads one table; faults are gathered.
class TableRowsReader {
 public:
  TableRowsReader(const Node& node, const SymbolTable& names, Faults& faults)
      : node_(node), names_(names), faults_(faults) {}

  TableRows read() {
    table_.file = names_.file;
    table_.mark = node_.mark;
    if (const Node* title = node_.find("title")) table_.title = title->text;
    if (const Node* where = node_.find("where"))
      table_.where = read_formula(*where, names_, "figure.where", faults_);
    read_headings();
    read_lines();
    table_.recording = common_recording(formulas(), names_, node_, "figure.rows", faults_);
    return std::move(table_);
  }

 private:
  void fault(const Mark& mark, const std::string& key, std::string message) {
    faults_.add({{names_.file, mark}, "figure." + key, std::move(message), {}});
  }

  void read_headings() {
    const Node* headings = node_.find("headings");
    if (!headings || !headings->is_list() || headings->items.size() < 2)
      return fault(headings ? headings->mark : node_.mark, "headings",
                   "'headings' is a list of texts, the first above the names of the rows: [of, found]");
    for (const Node& item : headings->items)
      table_.columns.push_back(item.text.empty() ? "" : read_text(item, names_, "figure.headings", faults_));
  }

  void read_lines() {
    const Node* rows = node_.find("rows");
    if (!rows || !rows->is_map() || rows->entries.empty())
      return fault(
          rows ? rows->mark : node_.mark, "rows",
          "'rows' is a map of names, with an expression for each further column: {NAME: [rig.x in mm]}");
    for (const Entry& entry : rows->entries) read_line(entry);
  }

  void read_line(const Entry& entry) {
    const auto items = entry.value.as_list();
    if (!table_.columns.empty() && items.size() + 1 != table_.columns.size())
      return fault(entry.value.mark, "rows",
                   fmt::format("'{}' has {} values, but there are {} headings behind that of the names",
                               entry.key, items.size(), table_.columns.size() - 1));
    TableRows::Line line{entry.key, {}};
    for (const Node& item : items)
      if (auto cell = read_series(item, names_, "figure.rows", faults_))
        line.cells.push_back(std::move(*cell));
    table_.lines.push_back(std::move(line));
  }

  std::vector<const Formula*> formulas() const {
    std::vector<const Formula*> all;
    if (table_.where) all.push_back(&*table_.where);
    for (const TableRows::Line& line : table_.lines)
      for (const Series& cell : line.cells) all.push_back(&cell.formula);
    return all;
  }

  const Node& node_;
  const SymbolTable& names_;
  Faults& faults_;
  TableRows table_;
};

std::string cell_text(const Series& cell, double value) {
  const bool bare = cell.unit_text.empty() || cell.unit_text == "1";
  return short_number(cell.unit.from_si(value)) + (bare ? "" : " " + cell.unit_text);
}

}  // namespace

TableRows read_table_rows(const Node& node, const SymbolTable& names, Faults& faults) {
  return TableRowsReader(node, names, faults).read();
}

TextTable filled(const TableRows& rows, std::span<const Recording> recordings) {
  const Recording& recording = recordings[rows.recording];
  const RunRows found = rows_of_run(rows.where, recording);
  if (found.none())
    throw Error(Fault{{rows.file, rows.mark}, "figure.where", "no row is left to be shown", {}});
  TextTable table{rows.title, rows.columns, {}, {}};
  for (const TableRows::Line& line : rows.lines) {
    table.rows.push_back({line.name});
    for (const Series& cell : line.cells)
      table.rows.back().push_back(cell_text(cell, evaluate(cell.formula, recording)[found.first]));
  }
  return table;
}

}  // namespace stepwire

#include "engine/view/plot/table_rows.hpp"

#include <fmt/format.h>

#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/run_rows.hpp"
#include "engine/base/text/count.hpp"
#include "engine/view/plot/panel_reading.hpp"

namespace stepwire::plot {

using yaml::form;

namespace {

using RowsTable = yaml::KeyTable<TableRows, query::NamesReading>;

void read_headings(TableRows& table, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_list() || node.items.size() < 2)
    return read.fault(node.mark,
                      "'headings' is a list of texts, the first above the names of the rows: [of, found]");
  for (const yaml::Node& item : node.items) table.columns.push_back(item.text.empty() ? "" : read.text(item));
}

/// Reads a line, with a value for each heading; requires the headings.
void read_line(TableRows& table, const yaml::Entry& entry, const query::NamesReading& read) {
  const auto items = entry.value.as_list();
  if (!table.columns.empty() && items.size() + 1 != table.columns.size())
    return read.fault(entry.value.mark,
                      fmt::format("'{}' has {}, but there are {} headings behind that of the names",
                                  entry.key, text::counted(items.size(), "value"), table.columns.size() - 1));
  TableRows::Line line{entry.key, {}};
  for (const yaml::Node& item : items)
    if (auto cell = read.series(item)) line.cells.push_back(std::move(*cell));
  table.lines.push_back(std::move(line));
}

void read_lines(TableRows& table, const yaml::Node& node, const query::NamesReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(
        node.mark,
        "'rows' is a map of names, with an expression for each further column: {NAME: [rig.x in mm]}");
  for (const yaml::Entry& entry : node.entries) read_line(table, entry, read);
}

const RowsTable& rows_table() {
  static const RowsTable table(
      "a table", "{headings: [of, found], rows: {NAME: [rig.x in mm]}}",
      {yaml::needed(RowsTable::Row{"headings", "texts, the first above the names of the rows",
                                   form::list(form::text(), 2), read_headings}),
       yaml::needed(RowsTable::Row{
           "rows", "names, with an expression for each further column, or a list: {NAME: [rig.x in mm]}",
           form::names(form::one_or_list(form::series()), 1), read_lines}),
       {"where", "cells have the values of the first row for which this is true; without it of the first",
        form::expression(), &TableRows::where}});
  return table;
}

std::vector<const query::Formula*> formulas_of(const TableRows& table) {
  std::vector<const query::Formula*> all;
  if (table.where) all.push_back(&*table.where);
  for (const TableRows::Line& line : table.lines)
    for (const query::Series& cell : line.cells) all.push_back(&cell.formula);
  return all;
}

std::string cell_text(const query::Series& cell, double value) {
  const bool bare = cell.unit_text.empty() || cell.unit_text == "1";
  return query::short_number(cell.unit.from_si(value)) + (bare ? "" : " " + cell.unit_text);
}

}  // namespace

const yaml::Key& table_rows_form() {
  return rows_table().form;
}

TableRows read_table_rows(const yaml::Node& node, const query::SymbolTable& names, yaml::Faults& faults) {
  TableRows table;
  table.file = names.file;
  table.mark = node.mark;
  if (const yaml::Node* title = node.find("title")) table.title = title->text;
  const query::NamesReading read("figure", names, faults);
  for (const yaml::Key& key : rows_table().form.of)
    if (key.required && !node.find(key.name))
      yaml::below(read, key.name).fault(node.mark, query::NamesReading::missing(key));
  yaml::set_keys(node, rows_table().rows, table, read);
  table.recording = query::common_recording(formulas_of(table), names, node, "figure.rows", faults);
  return table;
}

text::TextTable filled(const TableRows& rows, std::span<const record::Recording> recordings) {
  const record::Recording& recording = recordings[rows.recording];
  const query::RunRows found = query::rows_of_run(rows.where, recording);
  if (found.none())
    throw yaml::Error(yaml::Fault{{rows.file, rows.mark}, "figure.where", "no row is left to be shown", {}});
  text::TextTable table{rows.title, rows.columns, {}, {}};
  for (const TableRows::Line& line : rows.lines) {
    table.rows.push_back({line.name});
    for (const query::Series& cell : line.cells)
      table.rows.back().push_back(cell_text(cell, query::evaluate(cell.formula, recording)[found.first]));
  }
  return table;
}

}  // namespace stepwire::plot

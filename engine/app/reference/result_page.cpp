#include "engine/app/reference/result_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/app/reference/sheet_text.hpp"

namespace stepwire::reference {

namespace {

std::vector<std::string> row_of(const result::FieldType& field) {
  const std::string type = field.choices.empty() ? result::type_text(field.type)
                                                 : fmt::format("{}", fmt::join(field.choices, " or "));
  return {field.name, type, field.unit, field.doc};
}

/// Returns a table for each record, that of the result first.
std::vector<ReferenceTable> tables_of(const result::RecordType& type) {
  std::vector<ReferenceTable> tables;
  for (const result::RecordType* record : result::records_of({&type})) {
    ReferenceTable table{
        fmt::format("{}: {}", record->name, record->doc), {"field", "type", "unit", "meaning"}, {}};
    for (const result::FieldType& field : record->fields)
      if (!field.hidden) table.rows.push_back(row_of(field));
    tables.push_back(std::move(table));
  }
  std::ranges::rotate(tables, tables.end() - 1);
  return tables;
}

}  // namespace

std::string result_page(const result::RecordType& type) {
  std::string page;
  for (const ReferenceTable& table : tables_of(type)) page += table_text(table);
  return page.substr(page.find_first_not_of('\n'));
}

std::string result_markdown(const result::RecordType& type, int level) {
  const std::string marks(static_cast<std::size_t>(level), '#');
  std::string page = fmt::format("{} {}\n", marks, type.name);
  for (const ReferenceTable& table : tables_of(type)) page += table_markdown(table, marks);
  return page;
}

}  // namespace stepwire::reference

#include "engine/app/reference/format_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/app/reference/key_words.hpp"
#include "engine/app/reference/sheet_text.hpp"

namespace stepwire::reference {

namespace {

/// Returns the form of a section's value; empty if that is a plain map, whose keys have tables.
std::string value_line(const Section& section) {
  return section.form.form == yaml::Key::Form::keys ? "" : form_text(section.form);
}

}  // namespace

std::string format_page(const Section& section) {
  std::string page = fmt::format("{}\n  {}\n", section.name, wrapped(section.doc, 2));
  if (const std::string value = value_line(section); !value.empty())
    page += fmt::format("\n  value  {}\n", wrapped(value, 9));
  for (const ReferenceTable& table : key_tables(section.form)) page += table_text(table);
  return page + "\nExample\n" + indented(section.example) + "\n";
}

std::string format_markdown(const Section& section, int level) {
  const std::string marks(static_cast<std::size_t>(level), '#');
  std::string page = fmt::format("{} {}\n\n{}\n", marks, section.name, escaped(section.doc));
  if (const std::string value = value_line(section); !value.empty())
    page += fmt::format("\n- **value**: {}\n", escaped(value));
  for (const ReferenceTable& table : key_tables(section.form)) page += table_markdown(table, marks);
  return page + fmt::format("\n{}# Example\n\n```yaml\n{}\n```\n", marks, section.example);
}

std::string format_list() {
  std::size_t widest = 0;
  for (const Section& section : format_sections()) widest = std::max(widest, width(section.name));
  std::string list;
  for (const Section& section : format_sections())
    list +=
        "  " + padded(section.name, widest) + "  " + shortened(section.doc, page_width - widest - 4) + "\n";
  return list;
}

std::string formats_markdown() {
  std::string page = "# The format of a diagram\n";
  for (const Section& section : format_sections()) page += "\n" + format_markdown(section, 2);
  return page;
}

}  // namespace stepwire::reference

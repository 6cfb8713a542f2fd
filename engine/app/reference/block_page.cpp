#include "engine/app/reference/block_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/app/reference/families.hpp"
#include "engine/app/reference/sheet_text.hpp"
#include "engine/app/reference/words.hpp"

namespace stepwire::reference {

std::string block_page(const BlockType& type) {
  const BlockReference sheet = reference_of(type);
  std::string page = fmt::format("{} ({})\n  {}\n\n", sheet.name, sheet.folder, wrapped(sheet.doc, 2));
  for (const auto& [label, text] : sheet.facts)
    page += fmt::format("  {:<11}  {}\n", label, wrapped(text, 15));
  for (const ReferenceTable& table : sheet.tables) page += table_text(table);
  if (!sheet.remark.empty()) page += "\n  " + wrapped(sheet.remark, 2) + "\n";
  return page + "\nExample\n" + indented(sheet.example) + "\n";
}

std::string block_list(const Registry& registry) {
  std::size_t widest = 0;
  for (const std::string& name : registry.names()) widest = std::max(widest, width(name));
  std::string list;
  for (const auto& [folder, types] : families_of(registry)) {
    list += (list.empty() ? "" : "\n") + folder + "\n";
    for (const BlockType* type : types)
      list += "  " + padded(type->name, widest) + "  " +
              shortened(first_sentence(type->doc), page_width - widest - 4) + "\n";
  }
  return list;
}

}  // namespace stepwire::reference

#include "engine/app/reference/block_markdown.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/app/reference/families.hpp"
#include "engine/app/reference/sheet_text.hpp"
#include "engine/app/reference/words.hpp"

namespace stepwire::reference {

namespace {

/// Returns the anchor that common Markdown hosts give to a heading.
std::string anchor(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return "#" + name;
}

}  // namespace

std::string block_markdown(const BlockType& type, int level) {
  const BlockReference sheet = reference_of(type);
  const std::string marks(static_cast<std::size_t>(level), '#');
  std::string page = fmt::format("{} {}\n\n{}\n\n", marks, sheet.name, escaped(sheet.doc));
  page += fmt::format("- **family**: {}\n", sheet.folder);
  for (const auto& [label, text] : sheet.facts) page += fmt::format("- **{}**: {}\n", label, escaped(text));
  for (const ReferenceTable& table : sheet.tables) page += table_markdown(table, marks);
  if (!sheet.remark.empty()) page += "\n" + sheet.remark + "\n";
  return page + fmt::format("\n{}# Example\n\n```yaml\n{}\n```\n", marks, sheet.example);
}

std::string blocks_markdown(const Registry& registry) {
  std::string index = "# Blocks\n", pages;
  for (const auto& [folder, types] : families_of(registry)) {
    index += "\n## " + folder + "\n\n";
    for (const BlockType* type : types) {
      index +=
          fmt::format("- [{}]({}): {}\n", type->name, anchor(type->name), escaped(first_sentence(type->doc)));
      pages += "\n" + block_markdown(*type, 2);
    }
  }
  return index + pages;
}

}  // namespace stepwire::reference

#include "engine/app/reference/block_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <set>

#include "engine/app/reference/sheet_text.hpp"
#include "engine/app/reference/words.hpp"

namespace stepwire::reference {
namespace {

/// Returns all blocks by folder, both in alphabetical order.
inline std::map<std::string, std::vector<const BlockType*>> families_of(const Registry& registry) {
  std::map<std::string, std::vector<const BlockType*>> families;
  for (const BlockType* type : registry.types()) families[type->folder].push_back(type);
  return families;
}

/// Returns the anchor that common Markdown hosts give to a heading.
std::string anchor(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return "#" + name;
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Returns the searched text of a block's page, tables included. Keys that many blocks have are left out.
std::string searched_text(const BlockType& type) {
  std::string text = type.name + " " + type.folder + " " + type.doc + " " + type.source;
  for (const ParameterSpec& parameter : type.parameters) text += " " + parameter.name + " " + parameter.doc;
  for (const StateSpec& state : type.states)
    if (state.settable) text += " " + state.doc;
  for (const OutputSpec& output : type.outputs) text += " " + output.name + " " + output.doc;
  return in_small_letters(text);
}

std::string list_where(const Registry& registry, const std::function<bool(const BlockType&)>& shown) {
  std::size_t widest = 0;
  for (const std::string& name : registry.names()) widest = std::max(widest, width(name));
  std::string list;
  for (const auto& [folder, types] : families_of(registry)) {
    std::string lines;
    for (const BlockType* type : types)
      if (shown(*type))
        lines += "  " + padded(type->name, widest) + "  " +
                 shortened(first_sentence(type->doc), page_width - widest - 4) + "\n";
    if (!lines.empty()) list += (list.empty() ? "" : "\n") + folder + "\n" + lines;
  }
  return list;
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

std::string block_page(const BlockType& type) {
  return page_text(reference_of(type));
}

std::string page_text(const BlockReference& sheet) {
  std::string page = fmt::format("{} ({})\n  {}\n\n", sheet.name, sheet.folder, wrapped(sheet.doc, 2));
  for (const auto& [label, text] : sheet.facts)
    page += fmt::format("  {:<11}  {}\n", label, wrapped(text, 15));
  for (const ReferenceTable& table : sheet.tables) page += table_text(table);
  if (!sheet.remark.empty()) page += "\n  " + wrapped(sheet.remark, 2) + "\n";
  return page + "\nExample\n" + indented(sheet.example) + "\n";
}

std::string block_list(const Registry& registry) {
  return list_where(registry, [](const BlockType&) { return true; });
}

std::string blocks_about(const Registry& registry, const std::string& word) {
  const std::string wanted = in_small_letters(word);
  return list_where(
      registry, [&](const BlockType& type) { return searched_text(type).find(wanted) != std::string::npos; });
}

std::vector<std::string> searched_words(const Registry& registry) {
  constexpr std::size_t shortest = 4;  // shorter words are near too many others
  std::vector<std::string> names = registry.names();
  std::set<std::string> words;
  for (const std::string& name : names) {
    std::string text = searched_text(*registry.find(name)), word;
    text += ' ';
    for (const char letter : text) {
      if (std::isalpha(static_cast<unsigned char>(letter)))
        word += letter;
      else if (word.size() >= shortest)
        words.insert(std::move(word));
      if (!std::isalpha(static_cast<unsigned char>(letter))) word.clear();
    }
  }
  names.insert(names.end(), words.begin(), words.end());
  return names;
}

}  // namespace stepwire::reference

#include "engine/app/language/block_edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "engine/app/language/wire_edits.hpp"
#include "engine/app/reference/example.hpp"
#include "engine/app/reference/words.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/model/diagram/keys.hpp"

namespace stepwire::language {

namespace {

/// Remover of a block's names from lists.
class Forgetting {
 public:
  Forgetting(TreeEdits& edits, DiagramFiles& files, const std::string& file, const Meaning& meaning)
      : edits_(edits), text_(files.texts().text(file)), places_(*text_) {
    const std::vector<WrittenName> names = files.names(file);  // copied: resolving names reads other files
    for (const WrittenName& name : names) {
      const auto pieces = files.pieces(file, name);
      if (!pieces.empty() && pieces.front().meaning == meaning) uses_.push_back(name.range);
    }
  }

  void forget(const yaml::Node& node) {
    std::vector<const yaml::Node*> named;
    for (const yaml::Node& item : node.items) {
      if (is_use(item))
        named.push_back(&item);
      else
        forget(item);
    }
    if (named.size() < node.items.size())
      for (const yaml::Node* item : named) edits_.remove_item(node, *item);
    for (const yaml::Entry& entry : node.entries) forget(entry.value);
  }

 private:
  bool is_use(const yaml::Node& item) const {
    if (!item.is_scalar() || !diagram::is_dotted_name(item.text)) return false;
    const TextRange range = places_.range(item);
    return std::ranges::any_of(
        uses_, [&](const TextRange& use) { return range.from <= use.from && use.to <= range.to; });
  }

  TreeEdits& edits_;
  std::shared_ptr<const std::string> text_;
  TextPlaces places_;
  std::vector<TextRange> uses_;
};

bool is_taken(const yaml::Document& document, const std::string& name) {
  return std::ranges::any_of(
      std::initializer_list<const char*>{"blocks", "inputs", "parameters"},
      [&](const char* section) { return DiagramFiles::entry(document, section, name); });
}

/// Returns an unused name similar to the given one.
std::string free_name(const yaml::Document& document, std::string wanted) {
  for (char& c : wanted)
    if (!is_name_character(c)) c = '_';
  if (wanted.empty() || !(std::isalpha(static_cast<unsigned char>(wanted[0])) || wanted[0] == '_'))
    wanted.insert(0, "block_");
  std::string name = wanted;
  for (int i = 2; is_taken(document, name); ++i) name = fmt::format("{}_{}", wanted, i);
  return name;
}

TreeEdits::Keys keys_of(DiagramFiles& files, const std::string& type) {
  if (const BlockType* known = files.registry().find(type)) return reference::required_keys(*known);
  const std::string extension = std::filesystem::path(type).extension().string();
  if (extension != ".yaml" && extension != ".yml")
    throw EditRefused(fmt::format("there is no block '{}'", text::visible(type)));
  return {{"diagram", type}};
}

/// Returns the source of each input by its name; for a list input, all sources in one value.
TreeEdits::Keys feeds_of(DiagramFiles& files, const std::string& file, const yaml::Document& document,
                         const Insert& edit) {
  TreeEdits::Keys feeds;
  for (const auto& [input, signal] : edit.inputs) {
    const std::string key = input_place(input).key, source = source_text(files, file, document, signal);
    const BlockType* type = files.registry().find(edit.type);
    if (type && type->input(key) < 0)
      throw EditRefused(fmt::format("{} has no input '{}'", edit.type, text::visible(input)));
    const auto known = std::ranges::find(feeds, key, &TreeEdits::Keys::value_type::first);
    if (known == feeds.end())
      feeds.emplace_back(key, source);
    else
      known->second += ", " + source;
  }
  for (auto& [key, sources] : feeds)
    if (sources.find(',') != std::string::npos) sources = "[" + sources + "]";
  return feeds;
}

std::string usual_name(DiagramFiles& files, const std::string& type) {
  return files.registry().find(type) ? reference::snake_case(type)
                                     : std::filesystem::path(type).stem().string();
}

}  // namespace

void remove(TreeEdits& edits, DiagramFiles& files, const std::string& file, const yaml::Document& document,
            const Remove& edit) {
  const bool is_block = DiagramFiles::entry(document, "blocks", edit.name) != nullptr;
  const char* section = is_block ? "blocks" : "parameters";
  const yaml::Entry* entry = DiagramFiles::entry(document, section, edit.name);
  if (!entry) throw EditRefused(fmt::format("this file has no '{}'", text::visible(edit.name)));
  edits.remove(*document.root.find(section), *entry);
  Forgetting uses(edits, files, file,
                  {file, is_block ? Meaning::Kind::block : Meaning::Kind::parameter, edit.name});
  for (const yaml::Entry& one : document.root.entries)
    if (one.key != "blocks" && one.key != "parameters") uses.forget(one.value);
}

std::string insert(TreeEdits& edits, DiagramFiles& files, const std::string& file,
                   const yaml::Document& document, const Insert& edit) {
  TreeEdits::Keys keys = keys_of(files, edit.type);
  std::ranges::move(feeds_of(files, file, document, edit), std::back_inserter(keys));
  if (!edit.name.empty() && (!diagram::is_dotted_name(edit.name) || is_taken(document, edit.name)))
    throw EditRefused(fmt::format("'{}' is no name, or is taken", text::visible(edit.name)));
  const std::string name = edit.name.empty() ? free_name(document, usual_name(files, edit.type)) : edit.name;
  const yaml::Node* blocks = document.root.find("blocks");
  if (blocks && blocks->is_map()) {
    edits.add_map(*blocks, name, keys);
    return name;
  }
  std::string text;
  for (const auto& [key, value] : keys) text += (text.empty() ? "" : ", ") + key + ": " + value;
  text = fmt::format("{{{}: {{{}}}}}", name, text);
  if (blocks)
    edits.replace(*blocks, text);
  else
    edits.add(document.root, "blocks", text);
  return name;
}

}  // namespace stepwire::language

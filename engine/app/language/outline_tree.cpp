#include "engine/app/language/outline_tree.hpp"

#include <map>

namespace stepwire::language {

namespace {

using ItemKind = OutlineItem::Kind;

/// Returns the sections whose entries are listed, with the kind of their items.
const std::map<std::string, ItemKind>& listed_sections() {
  static const std::map<std::string, ItemKind> all{
      {"blocks", ItemKind::block}, {"parameters", ItemKind::parameter}, {"inputs", ItemKind::port},
      {"outputs", ItemKind::port}, {"claims", ItemKind::claim},         {"invariants", ItemKind::claim}};
  return all;
}

std::string scalar_under(const yaml::Node& map, const char* key) {
  const yaml::Node* value = map.is_map() ? map.find(key) : nullptr;
  return value && value->is_scalar() ? value->text : "";
}

std::string detail_of(const yaml::Node& value, ItemKind kind) {
  if (value.is_scalar()) return value.text;
  if (kind != ItemKind::block) return scalar_under(value, kind == ItemKind::port ? "unit" : "value");
  const std::string type = scalar_under(value, "block");
  return type.empty() ? scalar_under(value, "diagram") : type;
}

class Outlining {
 public:
  explicit Outlining(std::string_view text) : places_(text) {}

  std::vector<OutlineItem> sections(const yaml::Node& root) {
    std::vector<OutlineItem> items;
    for (const yaml::Entry& entry : root.entries) {
      items.push_back(item(entry, ItemKind::section));
      const auto listed = listed_sections().find(entry.key);
      if (listed == listed_sections().end()) continue;
      for (const yaml::Entry& inner : entry.value.entries)
        items.back().children.push_back(item(inner, listed->second));
      for (const yaml::Node& claim : entry.value.items) items.back().children.push_back(statement(claim));
    }
    return items;
  }

 private:
  OutlineItem item(const yaml::Entry& entry, ItemKind kind) {
    const bool part = kind == ItemKind::block && !scalar_under(entry.value, "diagram").empty();
    const TextRange key = places_.key_range(entry);
    const TextRange whole{key.from, std::max(key.to, places_.range(entry.value).to)};
    const std::string name = entry.key.empty() ? "''" : entry.key;  // editors refuse an empty name
    return {name,
            detail_of(entry.value, kind),
            part ? ItemKind::part : kind,
            places_.range(whole),
            places_.range(key),
            {}};
  }

  OutlineItem statement(const yaml::Node& claim) {
    const std::string that = scalar_under(claim, "that");
    const EditorRange range = places_.range(places_.range(claim));
    return {that.empty() ? "claim" : that, "", ItemKind::claim, range, range, {}};
  }

  TextPlaces places_;
};

}  // namespace

std::vector<OutlineItem> outline_of(const yaml::Document& document, std::string_view text) {
  return Outlining(text).sections(document.root);
}

}  // namespace stepwire::language

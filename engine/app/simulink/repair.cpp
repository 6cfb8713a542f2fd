#include "engine/app/simulink/repair.hpp"

#include <optional>

#include "engine/app/simulink/nodes.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {

namespace {

/// Indices of items and entries that lead to a value.
using NodePath = std::vector<std::size_t>;

bool is_at(const yaml::Node& node, const yaml::Mark& mark) {
  return node.is_scalar() && node.mark.line == mark.line && node.mark.column == mark.column;
}

std::optional<NodePath> path_to(const yaml::Node& node, const yaml::Mark& mark) {
  if (is_at(node, mark)) return NodePath{};
  for (std::size_t i = 0; i < node.items.size() + node.entries.size(); ++i) {
    const bool is_item = i < node.items.size();
    auto inner = path_to(is_item ? node.items[i] : node.entries[i - node.items.size()].value, mark);
    if (!inner) continue;
    inner->insert(inner->begin(), i);
    return inner;
  }
  return std::nullopt;
}

yaml::Node* node_at(yaml::Node& node, const NodePath& path) {
  yaml::Node* at = &node;
  for (const std::size_t i : path) {
    if (i >= at->items.size() + at->entries.size()) return nullptr;
    at = i < at->items.size() ? &at->items[i] : &at->entries[i - at->items.size()].value;
  }
  return at;
}

bool is_about_units(const yaml::Fault& fault) {
  const std::string text = fault.message.text();
  return text.find(" is in ") != text.npos &&
         (text.find(", but ") != text.npos || text.find("neither unit is known") != text.npos);
}

/// Puts the Gain before a source of a block.
bool add_gain(FlatModel& model, Unit& unit, const std::string& block_name, const NodePath& path) {
  for (const std::size_t index : unit.blocks) {
    FlatBlock& block = model.blocks()[index];
    for (auto& [name, made] : block.made) {
      if (name != block_name) continue;
      yaml::Node* source = node_at(made, path);
      if (!source || !source->is_scalar()) return false;
      const std::string gain = unit.take_name(block_name + "_number");
      yaml::Node node = map_of({{"block", word("Gain")}, {"u", word(source->text)}, {"gain", word("1")}});
      *source = word(gain);
      block.made.emplace_back(gain, std::move(node));
      return true;
    }
  }
  return false;
}

}  // namespace

bool free_unit(FlatModel& model, Unit& unit, const std::string& text, const yaml::Fault& fault) {
  if (!is_about_units(fault)) return false;
  const yaml::Document document = yaml::parse_document(text, fault.place.file);
  const yaml::Node* blocks = document.root.find("blocks");
  if (!blocks) return false;
  for (const yaml::Entry& entry : blocks->entries)
    if (const auto path = path_to(entry.value, fault.place.mark))
      return add_gain(model, unit, entry.key, *path);
  return false;
}

}  // namespace stepwire::simulink

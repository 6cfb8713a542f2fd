#include "engine/base/yaml/tree_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/base/yaml/message.hpp"

namespace stepwire::yaml {
namespace {

constexpr std::size_t characters_per_node = 32;  // bounds copies of long texts by aliases
constexpr std::size_t nodes_per_anchor = 8;      // approximate cost of storing the path to an anchor

struct Size {
  std::size_t cost = 0;
  std::size_t depth = 0;
};

std::size_t cost_of(const std::string& text) {
  return 1 + text.size() / characters_per_node;
}

Size size_of(const Node& node) {
  Size size{cost_of(node.text), 0};
  const auto add = [&](const Node& child) {
    const Size inner = size_of(child);
    size.cost += inner.cost;
    size.depth = std::max(size.depth, inner.depth);
  };
  for (const Node& item : node.items) add(item);
  for (const Entry& entry : node.entries) {
    size.cost += entry.key.size() / characters_per_node;
    add(entry.value);
  }
  if (node.is_list() || node.is_map()) ++size.depth;
  return size;
}

}  // namespace

TreeBuilder::TreeBuilder(std::string file, const DocumentLimits& limits)
    : file_(std::move(file)), limits_(limits) {
  root_.mark = root_.end = {1, 1};
}

void TreeBuilder::open(Node::Kind kind, Mark mark, std::size_t anchor) {
  if (awaits_key())
    fail(mark, "a list or a map cannot be a key; close the bracket, or quote text that starts with [ or {");
  check_depth(open_.size() + 1, mark);
  spend(1, mark);
  Node node;
  node.kind = kind;
  node.mark = mark;
  open_.push_back({&attach(std::move(node), anchor)});
}

void TreeBuilder::close(Mark end) {
  if (open_.back().node->is_map()) check_double_keys(*open_.back().node);
  open_.back().node->end = end;
  open_.pop_back();
}

void TreeBuilder::scalar(const MarkRange& place, const std::string& text, bool quoted, std::size_t anchor) {
  spend(cost_of(text), place.mark);
  if (awaits_key()) return key(place, text, anchor);
  Node node;
  node.kind = Node::Kind::scalar;
  node.quoted = quoted;
  node.mark = place.mark;
  node.end = place.end;
  node.text = text;
  attach(std::move(node), anchor);
}

void TreeBuilder::empty(const MarkRange& place, bool written, std::size_t anchor) {
  spend(1, place.mark);
  if (awaits_key()) {
    fault(place.mark, written ? "null is no key; quote it if it is meant as a word"
                              : "a key is missing before the value");
    return key(place, "", 0);
  }
  Node node;
  node.mark = place.mark;
  node.end = place.end;
  if (!written && !open_.empty() && open_.back().node->is_map()) {
    const Entry& entry = open_.back().node->entries.back();
    node.mark = entry.mark;
    node.end = entry.end;
    if (entry.key.find(':') != std::string::npos)
      fault(entry.mark, fault_text("'{}' is a key without a value; a blank is missing after ':'", entry.key));
  }
  attach(std::move(node), anchor);
}

void TreeBuilder::alias(Mark mark, std::size_t anchor) {
  if (awaits_key()) {
    fault(mark, "an alias (*name) cannot be a key; write the key out");
    return key({mark, mark}, "", 0);
  }
  const auto known = anchors_.find(anchor);
  if (known == anchors_.end())
    return empty({mark, mark}, true, 0);  // its anchor was on a key, which is already a fault
  const Node& meant = at(known->second);
  const bool is_open =
      std::any_of(open_.begin(), open_.end(), [&](auto& level) { return level.node == &meant; });
  if (is_open) fail(mark, "the alias stands inside the value that it names, so that it would never end");
  const Size size = size_of(meant);
  check_depth(open_.size() + size.depth, mark);
  spend(size.cost, mark);
  Node copy = meant;
  attach(std::move(copy), 0);
}

Mark TreeBuilder::innermost() const {
  return open_.empty() ? root_.mark : open_.back().node->mark;
}

void TreeBuilder::fault(Mark mark, Message message) {
  faults_.add({.place = {file_, mark}, .subject = "", .message = std::move(message), .used_by = {}});
}

void TreeBuilder::fail(Mark mark, Message message) {
  fault(mark, std::move(message));
  throw Error(faults_.list());
}

Node TreeBuilder::take() {
  faults_.throw_if_any();
  return std::move(root_);
}

bool TreeBuilder::awaits_key() const {
  return !open_.empty() && open_.back().node->is_map() && !open_.back().awaits_value;
}

void TreeBuilder::key(const MarkRange& place, std::string text, std::size_t anchor) {
  if (anchor != 0) fault(place.mark, "an anchor (&name) belongs to a value, not to a key");
  if (text == "<<")
    fault(place.mark, "merge keys (<<) are not known here; write the keys out, or give the value an alias");
  open_.back().node->entries.push_back({std::move(text), place.mark, {}, place.end});
  open_.back().awaits_value = true;
}

Node& TreeBuilder::attach(Node node, std::size_t anchor) {
  Node* place = &root_;
  if (!open_.empty()) {
    Node& parent = *open_.back().node;
    open_.back().awaits_value = false;
    place = parent.is_map() ? &parent.entries.back().value : &parent.items.emplace_back();
  }
  *place = std::move(node);
  if (anchor != 0) {
    spend(nodes_per_anchor, place->mark);
    Path path;
    for (const Level& level : open_)
      path.push_back((level.node->is_map() ? level.node->entries.size() : level.node->items.size()) - 1);
    anchors_[anchor] = std::move(path);
  }
  return *place;
}

void TreeBuilder::spend(std::size_t cost, Mark mark) {
  cost_ += cost;
  if (cost_ <= limits_.nodes) return;
  fail(mark, fmt::format("the file holds more than {} values (aliases expanded), more than is read",
                         limits_.nodes));
}

void TreeBuilder::check_depth(std::size_t depth, Mark mark) {
  if (depth <= static_cast<std::size_t>(limits_.depth)) return;
  fail(mark, fmt::format("nested deeper than {} levels, more than is read", limits_.depth));
}

void TreeBuilder::check_double_keys(const Node& map) {
  const std::vector<Entry>& entries = map.entries;
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return entries[a].key < entries[b].key; });
  std::size_t first = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Entry& original = entries[order[first]];
    const Entry& entry = entries[order[i]];
    if (entry.key != original.key) {
      first = i;
    } else if (!entry.key.empty()) {
      fault(entry.mark, fault_text("'{}' is given twice, first at {}:{}; leave one out", entry.key,
                                   original.mark.line, original.mark.column));
    }
  }
}

Node& TreeBuilder::at(const Path& path) {
  Node* node = &root_;
  for (const std::size_t index : path)
    node = node->is_map() ? &node->entries[index].value : &node->items[index];
  return *node;
}

}  // namespace stepwire::yaml

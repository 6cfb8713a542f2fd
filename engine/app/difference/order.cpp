#include "engine/app/difference/order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/base/yaml/yaml_text.hpp"

namespace stepwire::difference {

namespace {

using Names = std::vector<std::string>;

/// Returns the title, name, kind and axes of a figure or panel.
std::string item_text(const yaml::Node& item) {
  std::string text;
  for (const char* key : {"title", "name", "plot", "x", "y"})
    if (const yaml::Node* value = item.is_map() ? item.find(key) : nullptr)
      text += (text.empty() ? "" : " ") + yaml::yaml_line(*value);
  return text.empty() ? yaml::yaml_line(item) : text;
}

/// Walk through a file.
class Walk {
 public:
  explicit Walk(const std::function<std::string(const std::string&)>& renamed) : renamed_(renamed) {}

  Orders run(const yaml::Node& root) {
    walk(root, "");
    return std::move(orders_);
  }

  /// Returns the node of a place of the last run; nullptr without one.
  const yaml::Node* node(const std::string& place) const {
    const auto found = nodes_.find(place);
    return found == nodes_.end() ? nullptr : found->second;
  }

 private:
  void walk(const yaml::Node& node, const std::string& path) {
    for (const yaml::Entry& entry : node.entries) {
      const std::string name = path == "blocks" && renamed_ ? renamed_(entry.key) : entry.key;
      const std::string place = path.empty() ? name : path + "." + name;
      take(entry, place);
      walk(entry.value, place);
    }
    for (std::size_t i = 0; i < node.items.size(); ++i)
      walk(node.items[i], fmt::format("{}.{}", path, i + 1));
  }

  void take(const yaml::Entry& entry, const std::string& place) {
    static const std::set<std::string> maps{"states", "to", "counters"}, lists{"figure", "figures", "panels"};
    Names names;
    if (maps.contains(entry.key) && place.starts_with("blocks."))
      for (const yaml::Entry& one : entry.value.entries) names.push_back(one.key);
    if (lists.contains(entry.key)) {
      if (entry.value.is_map()) names.push_back(item_text(entry.value));
      for (const yaml::Node& one : entry.value.items) names.push_back(item_text(one));
    }
    if (names.empty()) return;
    orders_[place] = std::move(names);
    nodes_[place] = &entry.value;
  }

  const std::function<std::string(const std::string&)>& renamed_;
  Orders orders_;
  std::map<std::string, const yaml::Node*> nodes_;
};

/// Returns the names that are in both lists, in the order of the first.
Names shared(const Names& names, const Names& others) {
  std::multiset<std::string> rest(others.begin(), others.end());
  Names found;
  for (const std::string& name : names)
    if (const auto other = rest.find(name); other != rest.end()) {
      found.push_back(name);
      rest.erase(other);
    }
  return found;
}

Names at(const Orders& orders, const std::string& place) {
  const auto found = orders.find(place);
  return found == orders.end() ? Names{} : found->second;
}

}  // namespace

Orders orders_of(const yaml::Node& root, const std::function<std::string(const std::string&)>& renamed) {
  return Walk(renamed).run(root);
}

std::vector<ChangedOrder> changed_orders(const Orders& before, const Orders& after) {
  std::vector<ChangedOrder> changes;
  for (const auto& [place, names] : before) {
    const Names others = at(after, place), old = shared(names, others), now = shared(others, names);
    if (old != now)
      changes.push_back(
          {place, fmt::format("{}", fmt::join(old, ", ")), fmt::format("{}", fmt::join(now, ", "))});
  }
  return changes;
}

/// Returns the new name of each item where one side has the same items in the same places, some with another
/// name; std::nullopt where the order is another.
static std::optional<std::map<std::string, std::string>> new_labels(const Names& was, const Names& now) {
  if (was.size() != now.size()) return std::nullopt;
  std::map<std::string, std::string> labels;
  for (std::size_t i = 0; i < was.size(); ++i) {
    if (was[i] == now[i]) continue;
    if (std::ranges::count(was, was[i]) > 1 || std::ranges::count(now, was[i]) ||
        std::ranges::count(was, now[i]))
      return std::nullopt;
    labels[was[i]] = now[i];
  }
  return labels;
}

/// True where items changed in their places, and none has moved.
static bool keeps_places(const Names& was, const Names& now) {
  if (was.size() != now.size()) return false;
  const std::set<std::string> old(was.begin(), was.end());
  for (std::size_t i = 0; i < was.size(); ++i)
    if (was[i] != now[i] && old.contains(now[i])) return false;
  return true;
}

/// Returns the order that a merge of three versions has; std::nullopt where both sides changed it. An item
/// that both changed has the name of the merged text.
static std::optional<Names> wanted_order(const Names& was, const Names& ours, const Names& theirs,
                                         const Names& merged) {
  if (ours == theirs || theirs == was) return ours;
  if (ours == was) return theirs;
  if (keeps_places(was, ours) && keeps_places(was, theirs)) {
    Names wanted = ours;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (ours[i] == was[i]) wanted[i] = theirs[i];
      if (ours[i] != was[i] && theirs[i] != was[i] && i < merged.size()) wanted[i] = merged[i];
    }
    return wanted;
  }
  auto labels = new_labels(was, ours);
  const bool is_of_ours = labels.has_value();
  if (!is_of_ours) labels = new_labels(was, theirs);
  if (!labels) return std::nullopt;
  Names wanted = is_of_ours ? theirs : ours;
  for (std::string& name : wanted)
    if (const auto label = labels->find(name); label != labels->end()) name = label->second;
  return wanted;
}

std::optional<OrderedNode> ordered_node(const yaml::Node& root, const std::string& place) {
  const std::function<std::string(const std::string&)> renamed;
  Walk walk(renamed);
  Orders orders = walk.run(root);
  const yaml::Node* node = walk.node(place);
  return node ? std::optional(OrderedNode{node, std::move(orders[place])}) : std::nullopt;
}

std::vector<LostOrder> lost_orders(const Orders& base, const Orders& ours, const Orders& theirs,
                                   const Orders& merged) {
  std::vector<LostOrder> lost;
  std::set<std::string> places;
  for (const Orders* one : {&ours, &theirs})
    for (const auto& [place, names] : *one) places.insert(place);
  for (const std::string& place : places) {
    LostOrder one{place, at(base, place), at(ours, place), at(theirs, place), std::nullopt};
    one.wanted = wanted_order(one.base, one.ours, one.theirs, at(merged, place));
    if (!one.wanted || at(merged, place) != *one.wanted) lost.push_back(std::move(one));
  }
  return lost;
}

std::string orders_text(const Orders& orders) {
  std::string text;
  for (const auto& [place, names] : orders)
    if (names.size() > 1) text += fmt::format("order of {}: {}\n", place, fmt::join(names, ", "));
  return text;
}

}  // namespace stepwire::difference

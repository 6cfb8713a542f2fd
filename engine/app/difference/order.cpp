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
    if (lists.contains(entry.key))
      for (const yaml::Node& one : entry.value.items) names.push_back(item_text(one));
    if (names.size() > 1) orders_[place] = std::move(names);
  }

  const std::function<std::string(const std::string&)>& renamed_;
  Orders orders_;
};

/// Returns the names that are in both lists, in the order of the first.
Names shared(const Names& names, Names others) {
  Names found;
  for (const std::string& name : names)
    if (const auto other = std::ranges::find(others, name); other != others.end()) {
      found.push_back(name);
      others.erase(other);
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

std::vector<std::string> lost_orders(const Orders& base, const Orders& ours, const Orders& theirs,
                                     const Orders& merged) {
  std::vector<std::string> lost;
  std::set<std::string> places;
  for (const Orders* one : {&ours, &theirs})
    for (const auto& [place, names] : *one) places.insert(place);
  for (const std::string& place : places) {
    const Names was = at(base, place), our = at(ours, place), their = at(theirs, place);
    const bool both = our != was && their != was && our != their;
    const Names& wanted = our != was ? our : their;
    if (both || at(merged, place) != wanted) lost.push_back(place);
  }
  return lost;
}

std::string orders_text(const Orders& orders) {
  std::string text;
  for (const auto& [place, names] : orders)
    text += fmt::format("order of {}: {}\n", place, fmt::join(names, ", "));
  return text;
}

}  // namespace stepwire::difference

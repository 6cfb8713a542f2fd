#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"

namespace stepwire::difference {

/// Orders of a file that have a meaning, by their places: states of a chart, the first of which is initial,
/// transitions, counters, and figures with panels, which claims name by number.
using Orders = std::map<std::string, std::vector<std::string>>;

/// Returns the orders of a file. `renamed` gives the new name of a block.
Orders orders_of(const yaml::Node& root, const std::function<std::string(const std::string&)>& renamed = {});

/// Order of the items that two versions share, and that differs.
struct ChangedOrder {
  std::string place;  ///< "blocks.chart.states"
  std::string before, after;
};
std::vector<ChangedOrder> changed_orders(const Orders& before, const Orders& after);

/// Node of a file whose order has a meaning, with the names of its items.
struct OrderedNode {
  const yaml::Node* node = nullptr;
  std::vector<std::string> names;
};
/// Returns the node of a place of orders_of(); std::nullopt where the file has none there.
std::optional<OrderedNode> ordered_node(const yaml::Node& root, const std::string& place);

/// Place at which a merged file lacks the order of the versions.
struct LostOrder {
  std::string place;
  std::vector<std::string> base, ours, theirs;
  /// The right order; std::nullopt where both sides changed it in different ways. An item that only has
  /// another name, in its place, is no change of the order.
  std::optional<std::vector<std::string>> wanted;
};
std::vector<LostOrder> lost_orders(const Orders& base, const Orders& ours, const Orders& theirs,
                                   const Orders& merged);

/// Returns the orders in sorted lines.
std::string orders_text(const Orders& orders);

}  // namespace stepwire::difference

#pragma once

#include <functional>
#include <map>
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

/// Returns the places at which a merged file has not the order of the side that changed it, and those that
/// both sides changed in different ways.
std::vector<std::string> lost_orders(const Orders& base, const Orders& ours, const Orders& theirs,
                                     const Orders& merged);

/// Returns the orders in sorted lines.
std::string orders_text(const Orders& orders);

}  // namespace stepwire::difference

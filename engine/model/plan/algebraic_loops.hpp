#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/order_graph.hpp"

namespace stepwire::plan {

/// Nodes that all feed each other, in ascending order.
using LoopNodes = std::vector<std::size_t>;

/// The loops of a graph, in the order of their first nodes.
std::vector<LoopNodes> find_loops(const OrderGraph& graph);

/// A shortest way from the first node of a loop back to itself.
std::vector<std::size_t> shortest_cycle(const OrderGraph& graph, const LoopNodes& nodes);

/// "error -> half -> twice -> error"
std::string loop_path(const Draft& draft, const OrderGraph& graph, const LoopNodes& nodes);

/// Adds the fault of a loop that is not to be solved.
void refuse_loop(Draft& draft, const OrderGraph& graph, const LoopNodes& nodes);

/// The blocks of a loop in the order of their calls, and where it is torn for that.
struct LoopOrder {
  std::vector<std::size_t> tears;  ///< nodes
  std::vector<int> blocks;         ///< one of which only some outputs can be computed at a time stands twice
};
LoopOrder order_loop(const Draft& draft, const OrderGraph& graph, const LoopNodes& nodes);

}  // namespace stepwire::plan

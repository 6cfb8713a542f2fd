#pragma once

#include <string>
#include <vector>

#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/order_graph.hpp"

namespace stepwire::plan {

/// Nodes of a strongly connected component, in ascending order.
using LoopNodes = std::vector<std::size_t>;

/// Returns the loops of a graph, in the order of their first nodes.
std::vector<LoopNodes> find_loops(const OrderGraph& graph);

/// Returns a shortest cycle through the first node of a loop.
std::vector<std::size_t> shortest_cycle(const OrderGraph& graph, const LoopNodes& nodes);

/// Returns a cycle as text, "error -> half -> twice -> error".
std::string loop_path(const Draft& draft, const OrderGraph& graph, const LoopNodes& nodes);

/// Adds the fault of a loop that must not be solved.
void refuse_loop(Draft& draft, const OrderGraph& graph, const LoopNodes& nodes);

/// Call order of the blocks of a loop, and its tears.
struct LoopOrder {
  std::vector<std::size_t> tears;  ///< indices of torn nodes
  std::vector<int> blocks;         ///< a block with outputs that need two calls occurs twice
};
LoopOrder order_loop(const Draft& draft, const OrderGraph& graph, const LoopNodes& nodes);

}  // namespace stepwire::plan

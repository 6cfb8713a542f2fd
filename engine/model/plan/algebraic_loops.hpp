#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

/// Dependence graph. Its nodes are computed outputs; an edge leads from an output to each output that depends
/// on it at the same instant.
struct OrderGraph {
  std::vector<std::vector<std::size_t>> edges;              ///< readers of each node
  std::vector<std::pair<std::size_t, std::size_t>> owners;  ///< block and output of each node
  std::vector<std::size_t> first;                           ///< first node of each block; then their number

  std::size_t count(std::size_t block) const { return first[block + 1] - first[block]; }
  /// Returns the nodes that depend on a node at the same instant.
  const std::vector<std::size_t>& readers(std::size_t node) const { return edges[node]; }
};

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

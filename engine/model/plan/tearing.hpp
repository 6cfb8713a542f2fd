#pragma once

#include <vector>

#include "engine/model/plan/order_graph.hpp"

namespace stepwire::plan {

/// The fewest of these nodes, beside those that are `given`, without which the others do not feed each other, in ascending order; of sets
/// with as many nodes one with the fewest numbers, of which each node has `sizes`. Exact as long as few are
/// left to choose from once all has been tried that costs nothing; beyond, the node with the most ways through
/// it is taken first.
std::vector<std::size_t> tear(const OrderGraph& graph, const std::vector<std::size_t>& nodes,
                              const std::vector<std::size_t>& sizes,
                              const std::vector<std::size_t>& given = {});

}  // namespace stepwire::plan

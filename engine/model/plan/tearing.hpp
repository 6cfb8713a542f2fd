#pragma once

#include <vector>

#include "engine/model/plan/order_graph.hpp"

namespace stepwire::plan {

/// Returns a set of nodes, in ascending order, whose removal leaves no cycle (a feedback vertex set); the
/// nodes in `given` are always torn.
///
/// Each torn node adds unknowns to the solution of an algebraic loop. So the set has the fewest nodes, and
/// among those the smallest total of `sizes`. The problem is NP-hard. Reductions of Levy and Low that keep an
/// optimum solve most graphs; the rest is searched by branch and bound. The result is exact up to a fixed
/// number of branches. Beyond them the search is greedy and tears the node with the most paths through it.
std::vector<std::size_t> tear(const OrderGraph& graph, const std::vector<std::size_t>& nodes,
                              const std::vector<std::size_t>& sizes,
                              const std::vector<std::size_t>& given = {});

}  // namespace stepwire::plan

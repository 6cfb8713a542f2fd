#pragma once

#include <utility>
#include <vector>

namespace stepwire::plan {

/// Nodes that follow from no other one, and of each loop of nodes that follow from each other alone the first
/// that may be chosen. `followings` has pairs of a node and one that it follows from; only those of nodes
/// that are `open` count. The result does not depend on the order of the pairs.
std::vector<int> ends_of_chains(const std::vector<bool>& open, const std::vector<bool>& may_be_chosen,
                                const std::vector<std::pair<int, int>>& followings);

}  // namespace stepwire::plan

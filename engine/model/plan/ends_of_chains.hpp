#pragma once

#include <utility>
#include <vector>

namespace stepwire::plan {

/// Finds the open nodes that follow from no other open one. Of a loop of nodes that follow from each other
/// alone it takes the first that may be chosen. `followings` has pairs of a node and one that it follows from,
/// in any order.
std::vector<int> ends_of_chains(const std::vector<bool>& open, const std::vector<bool>& may_be_chosen,
                                const std::vector<std::pair<int, int>>& followings);

}  // namespace stepwire::plan

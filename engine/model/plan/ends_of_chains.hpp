#pragma once

#include <utility>
#include <vector>

namespace stepwire::plan {

/// Finds the open nodes that depend on no other open node. Of a strongly connected component without further
/// dependences it selects the first eligible node. `followings` has pairs of a node and one that it depends
/// on, in any order. The components are found by Tarjan's algorithm in linear time.
std::vector<int> ends_of_chains(const std::vector<bool>& open, const std::vector<bool>& may_be_chosen,
                                const std::vector<std::pair<int, int>>& followings);

}  // namespace stepwire::plan

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

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

}  // namespace stepwire::plan

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace stepwire::plan {

/// What must be known before what: nodes are outputs that are computed, and an edge leads from an output to each
/// output that depends on it at the same instant.
struct OrderGraph {
  std::vector<std::vector<std::size_t>> edges;              ///< of each node to those that depend on it
  std::vector<std::pair<std::size_t, std::size_t>> owners;  ///< block and output of each node
  std::vector<std::size_t> first;                           ///< node of each block; behind them their number

  std::size_t count(std::size_t block) const { return first[block + 1] - first[block]; }
  /// What depends on a node at the same instant.
  const std::vector<std::size_t>& readers(std::size_t node) const { return edges[node]; }
};

}  // namespace stepwire::plan

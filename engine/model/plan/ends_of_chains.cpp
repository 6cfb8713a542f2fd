#include "engine/model/plan/ends_of_chains.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace stepwire::plan {

std::vector<int> ends_of_chains(const std::vector<bool>& open, const std::vector<bool>& may_be_chosen,
                                const std::vector<std::pair<int, int>>& followings) {
  const auto is_open = [&](int node) { return open[static_cast<std::size_t>(node)]; };
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> edges(open.size());
  for (const auto& [node, from] : followings)
    if (is_open(node) && is_open(from))
      boost::add_edge(static_cast<std::size_t>(node), static_cast<std::size_t>(from), edges);
  std::vector<std::size_t> component(open.size());
  const std::size_t count = boost::strong_components(edges, component.data());
  std::vector<bool> has_end(count, true);
  for (const auto& [node, from] : followings) {
    const std::size_t own = component[static_cast<std::size_t>(node)];
    if (is_open(node) && is_open(from) && own != component[static_cast<std::size_t>(from)])
      has_end[own] = false;
  }
  std::vector<int> chosen;
  for (std::size_t node = 0; node < open.size(); ++node) {
    if (!open[node] || !may_be_chosen[node] || !has_end[component[node]]) continue;
    has_end[component[node]] = false;
    chosen.push_back(static_cast<int>(node));
  }
  return chosen;
}

}  // namespace stepwire::plan

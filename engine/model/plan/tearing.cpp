#include "engine/model/plan/tearing.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace stepwire::plan {

namespace {

constexpr int max_tries = 20'000;  // of branches of the search

/// Cost of a set of tears: first the number of nodes, then their total size.
struct TearCost {
  std::size_t nodes = 0, numbers = 0;
  auto operator<=>(const TearCost&) const = default;
};

/// Remainder of a graph under the reductions of Levy and Low (1988, J. Algorithms 9(4)).
class Remaining {
 public:
  Remaining(const OrderGraph& graph, const std::vector<std::size_t>& nodes,
            const std::vector<std::size_t>& sizes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes_[nodes[i]].size = sizes[i];
    for (const std::size_t node : nodes)
      for (const std::size_t reader : graph.readers(node))
        if (nodes_.contains(reader)) connect(node, reader);
  }

  bool empty() const { return nodes_.empty(); }
  const std::set<std::size_t>& torn() const { return torn_; }
  TearCost cost() const { return cost_; }

  /// Applies all reductions that keep an optimal solution: tears nodes that read themselves, removes nodes
  /// outside of all cycles, and bypasses nodes with a single source or reader that costs no more.
  void reduce() {
    bool changed = true;
    while (changed) {
      changed = false;
      for (auto it = nodes_.begin(); it != nodes_.end();) {
        const std::size_t node = (it++)->first;
        changed = reduce(node) || changed;
      }
    }
  }

  void tear(std::size_t node) {
    torn_.insert(node);
    ++cost_.nodes;
    cost_.numbers += nodes_.at(node).size;
    remove(node);
  }
  /// Decides that a node is not torn: its sources are connected to its readers.
  void bypass(std::size_t node) {
    const Node old = nodes_.at(node);
    remove(node);
    for (const std::size_t from : old.from)
      for (const std::size_t to : old.to) connect(from, to);
  }

  /// Returns the node with the most paths through it.
  std::size_t busiest() const {
    const auto ways = [](const auto& one) { return one.second.from.size() * one.second.to.size(); };
    return std::max_element(nodes_.begin(), nodes_.end(),
                            [&](const auto& a, const auto& b) {
                              return ways(a) < ways(b) ||
                                     (ways(a) == ways(b) && a.second.size > b.second.size);
                            })
        ->first;
  }

 private:
  struct Node {
    std::size_t size = 1;
    std::set<std::size_t> from{}, to{};
  };

  void connect(std::size_t from, std::size_t to) {
    nodes_[from].to.insert(to);
    nodes_[to].from.insert(from);
  }
  void remove(std::size_t node) {
    for (const std::size_t from : nodes_.at(node).from) nodes_.at(from).to.erase(node);
    for (const std::size_t to : nodes_.at(node).to) nodes_.at(to).from.erase(node);
    nodes_.erase(node);
  }

  bool reduce(std::size_t node) {
    const Node& one = nodes_.at(node);
    if (one.to.contains(node)) return tear(node), true;
    if (one.from.empty() || one.to.empty()) return remove(node), true;
    const bool gives_way = (one.from.size() == 1 && nodes_.at(*one.from.begin()).size <= one.size) ||
                           (one.to.size() == 1 && nodes_.at(*one.to.begin()).size <= one.size);
    if (gives_way) bypass(node);
    return gives_way;
  }

  std::map<std::size_t, Node> nodes_;
  std::set<std::size_t> torn_;
  TearCost cost_;
};

/// Branch and bound: tears or bypasses each remaining node.
class Search {
 public:
  std::set<std::size_t> run(const Remaining& start) {
    go_on(start);
    return std::move(best_);
  }

 private:
  void go_on(Remaining rest) {
    rest.reduce();
    if (found_ && !(rest.cost() < cost_)) return;
    if (rest.empty()) {
      found_ = true;
      cost_ = rest.cost();
      best_ = rest.torn();
      return;
    }
    const std::size_t node = rest.busiest();
    Remaining torn = rest;
    torn.tear(node);
    go_on(std::move(torn));
    if (++tries_ > max_tries) return;
    rest.bypass(node);
    go_on(std::move(rest));
  }

  bool found_ = false;
  TearCost cost_;
  std::set<std::size_t> best_;
  int tries_ = 0;
};

}  // namespace

std::vector<std::size_t> tear(const OrderGraph& graph, const std::vector<std::size_t>& nodes,
                              const std::vector<std::size_t>& sizes,
                              const std::vector<std::size_t>& given) {
  Remaining start(graph, nodes, sizes);
  for (const std::size_t node : given) start.tear(node);
  const std::set<std::size_t> torn = Search().run(start);
  return {torn.begin(), torn.end()};
}

}  // namespace stepwire::plan

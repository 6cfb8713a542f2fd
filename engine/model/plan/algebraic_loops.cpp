#include "engine/model/plan/algebraic_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <deque>
#include <map>
#include <optional>
#include <set>

#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/diagram/output_names.hpp"

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

/// Returns a set of nodes, in ascending order, whose removal leaves no cycle (a feedback vertex set); the
/// nodes in `given` are always torn.
///
/// Each torn node adds unknowns to the solution of an algebraic loop. So the set has the fewest nodes, and
/// among those the smallest total of `sizes`. The problem is NP-hard. Reductions of Levy and Low that keep an
/// optimum solve most graphs; the rest is searched by branch and bound. The result is exact up to a fixed
/// number of branches. Beyond them the search is greedy and tears the node with the most paths through it.
std::vector<std::size_t> tear(const OrderGraph& graph, const std::vector<std::size_t>& nodes,
                              const std::vector<std::size_t>& sizes,
                              const std::vector<std::size_t>& given = {}) {
  Remaining start(graph, nodes, sizes);
  for (const std::size_t node : given) start.tear(node);
  const std::set<std::size_t> torn = Search().run(start);
  return {torn.begin(), torn.end()};
}

/// Text of a cycle for messages. Ports are named for blocks with several inputs, since the loop may use only
/// some of them.
class CycleText {
 public:
  CycleText(const Draft& draft, const OrderGraph& graph, const std::vector<std::size_t>& cycle)
      : draft_(draft), graph_(graph), cycle_(cycle) {}

  std::string text(bool with_places) const {
    std::string text;
    for (std::size_t i = 0; i < cycle_.size(); ++i) text += hop(i, with_places) + " -> ";
    const std::string entry = entry_port(0);
    return text + (entry.empty() ? output_name(cycle_.front()) : entry);
  }

 private:
  const diagram::DiagramBlock& block_of(std::size_t node) const {
    return draft_.plan.diagram.blocks[graph_.owners[node].first];
  }

  std::string hop(std::size_t i, bool with_place) const {
    const diagram::DiagramBlock& block = block_of(cycle_[i]);
    const std::string entry = entry_port(i);
    const std::string& port = block.type().outputs[graph_.owners[cycle_[i]].second].name;
    const std::string name =
        entry.empty() ? output_name(cycle_[i]) : fmt::format("{} -> {}.{}", entry, block.name, port);
    const yaml::Place place = draft_.plan.diagram.place(block.origin);
    return with_place ? fmt::format("{} ({}:{})", name, place.file, place.mark.line) : name;
  }

  std::string output_name(std::size_t node) const {
    const diagram::DiagramBlock& block = block_of(node);
    return diagram::output_name(block.name, block.type(), graph_.owners[node].second);
  }

  /// Returns the input through which the cycle enters its i-th node; empty for a block with one connected
  /// input.
  std::string entry_port(std::size_t i) const {
    const auto [from, from_output] = graph_.owners[cycle_[(i + cycle_.size() - 1) % cycle_.size()]];
    const auto [at, output] = graph_.owners[cycle_[i]];
    const diagram::DiagramBlock& block = block_of(cycle_[i]);
    const auto connected = std::ranges::count_if(block.inputs, [](const auto& all) { return !all.empty(); });
    if (connected < 2) return "";
    for (std::size_t input = 0; input < block.inputs.size(); ++input)
      for (const diagram::Source& source : block.inputs[input])
        if (source.block == static_cast<int>(from) && source.output == static_cast<int>(from_output) &&
            draft_.depends(at, input, output))
          return block.name + "." + block.type().inputs[input].name;
    return "";
  }

  const Draft& draft_;
  const OrderGraph& graph_;
  const std::vector<std::size_t>& cycle_;
};

/// Topological order of the blocks of a torn loop.
class TornOrder {
 public:
  TornOrder(const OrderGraph& graph, const LoopNodes& nodes, const std::vector<std::size_t>& tears)
      : graph_(graph), nodes_(nodes), torn_(tears.begin(), tears.end()) {
    for (const std::size_t node : nodes) waiting_[node] = 0;
    for (const std::size_t node : nodes) each_reader(node, [&](std::size_t reader) { ++waiting_[reader]; });
  }

  std::vector<int> run() {
    while (!waiting_.empty()) call(next());
    return std::move(blocks_);
  }

 private:
  template <class Visit>
  void each_reader(std::size_t node, const Visit& visit) const {
    if (torn_.contains(node)) return;
    for (const std::size_t reader : graph_.readers(node))
      if (waiting_.contains(reader)) visit(reader);
  }

  /// Returns the first block whose open nodes are all ready, else the first with some ready nodes.
  std::size_t next() const {
    std::optional<std::size_t> in_part;
    for (const auto& [node, count] : waiting_) {
      if (count > 0) continue;
      const std::size_t block = graph_.owners[node].first;
      if (all_ready(block)) return block;
      if (!in_part) in_part = block;
    }
    return *in_part;
  }

  bool all_ready(std::size_t block) const {
    for (std::size_t node = graph_.first[block]; node < graph_.first[block + 1]; ++node)
      if (const auto found = waiting_.find(node); found != waiting_.end() && found->second > 0) return false;
    return true;
  }

  void call(std::size_t block) {
    blocks_.push_back(static_cast<int>(block));
    std::vector<std::size_t> ready;
    for (std::size_t node = graph_.first[block]; node < graph_.first[block + 1]; ++node)
      if (const auto found = waiting_.find(node); found != waiting_.end() && found->second == 0)
        ready.push_back(node);
    for (const std::size_t node : ready) waiting_.erase(node);
    for (const std::size_t node : ready) each_reader(node, [&](std::size_t reader) { --waiting_[reader]; });
  }

  const OrderGraph& graph_;
  const LoopNodes& nodes_;
  std::set<std::size_t> torn_;
  std::map<std::size_t, int> waiting_;  ///< for each uncalled node, the number of nodes that it waits for
  std::vector<int> blocks_;
};

/// Returns the nodes of a loop in the canonical order of their blocks.
LoopNodes canonical_nodes(const Draft& draft, const OrderGraph& graph, const LoopNodes& nodes) {
  std::vector<std::size_t> place(draft.canonical.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[static_cast<std::size_t>(draft.canonical[i])] = i;
  LoopNodes canonical = nodes;
  std::ranges::sort(canonical, {}, [&](std::size_t node) {
    return std::pair(place[graph.owners[node].first], graph.owners[node].second);
  });
  return canonical;
}

/// Returns the tears of a loop. The canonical order of the blocks selects among sets of equal cost. So the
/// loop is copied into a graph with its nodes in that order.
std::vector<std::size_t> tears_of(const Draft& draft, const OrderGraph& graph, const LoopNodes& nodes) {
  const LoopNodes canonical = canonical_nodes(draft, graph, nodes);
  std::map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < canonical.size(); ++i) place[canonical[i]] = i;
  OrderGraph loop;
  std::vector<std::size_t> all, sizes, given;
  for (const std::size_t node : canonical) {
    const auto [block, output] = graph.owners[node];
    if (draft.type(block).torn) given.push_back(all.size());
    all.push_back(all.size());
    sizes.push_back(static_cast<std::size_t>(draft.blocks[block].output_sizes[output]));
    std::vector<std::size_t>& readers = loop.edges.emplace_back();
    for (const std::size_t reader : graph.readers(node))
      if (const auto found = place.find(reader); found != place.end()) readers.push_back(found->second);
  }
  std::vector<std::size_t> tears;
  for (const std::size_t i : tear(loop, all, sizes, given)) tears.push_back(canonical[i]);
  return tears;
}

}  // namespace

std::vector<LoopNodes> find_loops(const OrderGraph& graph) {
  std::vector<int> component(graph.owners.size());
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> edges(graph.owners.size());
  for (std::size_t node = 0; node < graph.owners.size(); ++node)
    for (const std::size_t reader : graph.readers(node)) boost::add_edge(node, reader, edges);
  const int count = boost::strong_components(edges, component.data());
  std::vector<LoopNodes> members(static_cast<std::size_t>(count));
  for (std::size_t n = 0; n < graph.owners.size(); ++n)
    members[static_cast<std::size_t>(component[n])].push_back(n);
  std::erase_if(members, [&](const LoopNodes& nodes) {
    return nodes.size() == 1 && std::ranges::count(graph.readers(nodes[0]), nodes[0]) == 0;
  });
  return members;
}

std::vector<std::size_t> shortest_cycle(const OrderGraph& graph, const LoopNodes& nodes) {
  const std::size_t start = nodes.front();
  std::map<std::size_t, std::size_t> came_from;
  std::deque<std::size_t> queue{start};
  while (!queue.empty() && !came_from.contains(start)) {
    const std::size_t node = queue.front();
    queue.pop_front();
    for (const std::size_t next : graph.readers(node)) {
      if (!std::ranges::binary_search(nodes, next) || came_from.contains(next)) continue;
      came_from[next] = node;
      queue.push_back(next);
    }
  }
  std::vector<std::size_t> path{start};
  for (std::size_t node = came_from[start]; node != start; node = came_from[node]) path.push_back(node);
  std::reverse(path.begin() + 1, path.end());
  return path;
}

std::string loop_path(const Draft& draft, const OrderGraph& graph, const LoopNodes& nodes) {
  return CycleText(draft, graph, shortest_cycle(graph, nodes)).text(false);
}

void refuse_loop(Draft& draft, const OrderGraph& graph, const LoopNodes& nodes) {
  const diagram::DiagramBlock& block = draft.diagram().blocks[graph.owners[nodes.front()].first];
  std::string cure =
      "break it with a block whose output does not follow its input at once (a Lag, an Integrator, a "
      "UnitDelay), "
      "or have it solved at every instant: 'algebraic_loops: solve' in the head of the file";
  for (const std::size_t node : nodes)
    if (const diagram::DiagramBlock& guard = draft.diagram().blocks[graph.owners[node].first];
        &guard.type() == &diagram::guard_type())
      cure = fmt::format(
          "{} decides whether what it guards runs, so it cannot follow from that; feed its condition from "
          "outside, "
          "or through a UnitDelay that stands outside",
          guard.name);
  draft.report.add(block.origin, block.name,
                   fmt::format("algebraic loop: each of these feeds the next at the same instant: {}; {}",
                               CycleText(draft, graph, shortest_cycle(graph, nodes)).text(true), cure));
}

LoopOrder order_loop(const Draft& draft, const OrderGraph& graph, const LoopNodes& nodes) {
  LoopOrder order;
  order.tears = tears_of(draft, graph, nodes);
  order.blocks = TornOrder(graph, nodes, order.tears).run();
  return order;
}

}  // namespace stepwire::plan

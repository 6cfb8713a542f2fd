#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <deque>
#include <map>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;

/// The graph of what must be known before what: its nodes are outputs that are computed, and an edge leads
/// from an output to each output that depends on it at the same instant.
class Order {
 public:
  explicit Order(Draft& draft) : draft_(draft) {
    for (std::size_t b = 0; b < draft.blocks.size(); ++b) {
      first_node_.push_back(owners_.size());
      for (std::size_t o = 0; o < draft.type(b).outputs.size(); ++o)
        if (draft.blocks[b].computes) owners_.emplace_back(b, o);
    }
    first_node_.push_back(owners_.size());
    for (std::size_t n = 0; n < owners_.size(); ++n) boost::add_vertex(graph_);
    waiting_.assign(owners_.size(), 0);
    for (std::size_t b = 0; b < draft.blocks.size(); ++b) add_edges(b);
  }

  std::vector<int> run() {
    if (refuse_loops()) return {};
    mark_stages();
    return schedule();
  }

 private:
  std::size_t node_count(std::size_t block) const { return first_node_[block + 1] - first_node_[block]; }

  /// What depends on a node at the same instant.
  auto readers(std::size_t node) const {
    return boost::make_iterator_range(boost::adjacent_vertices(node, graph_));
  }

  /// The node that computes a source, or nothing for states and constants.
  std::optional<std::size_t> node_of(const diagram::Source& source) const {
    if (source.block < 0 || !draft_.blocks[static_cast<std::size_t>(source.block)].computes)
      return std::nullopt;
    return first_node_[static_cast<std::size_t>(source.block)] + static_cast<std::size_t>(source.output);
  }

  /// Is a block called before another in any case, from a table of its own?
  bool comes_first(std::size_t block, std::size_t other) const {
    const auto table = [&](std::size_t b) {
      return draft_.plan.blocks[b].rate.kind == Rate::Kind::constant ? 0 : draft_.blocks[b].timed ? 1 : 2;
    };
    return table(block) < table(other);
  }

  void add_edges(std::size_t block) {
    const auto& inputs = draft_.diagram().blocks[block].inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      for (const diagram::Source& source : inputs[i])
        if (const auto from = node_of(source); from && !comes_first(owners_[*from].first, block))
          for (std::size_t o = 0; o < node_count(block); ++o)
            if (draft_.depends(block, i, o)) add_edge(*from, first_node_[block] + o);
  }

  void add_edge(std::size_t from, std::size_t to) {
    boost::add_edge(from, to, graph_);
    ++waiting_[to];
  }

  bool refuse_loops() {
    std::vector<int> component(owners_.size());
    const int count = boost::strong_components(graph_, component.data());
    std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(count));
    for (std::size_t n = 0; n < owners_.size(); ++n)
      members[static_cast<std::size_t>(component[n])].push_back(n);
    bool refused = false;
    for (const auto& nodes : members) {
      if (nodes.size() == 1 && !boost::edge(nodes[0], nodes[0], graph_).second) continue;
      refuse(cycle(*std::min_element(nodes.begin(), nodes.end()), component));
      refused = true;
    }
    return refused;
  }

  /// A shortest way from a node back to itself inside of its component.
  std::vector<std::size_t> cycle(std::size_t start, const std::vector<int>& component) const {
    std::map<std::size_t, std::size_t> came_from;
    std::deque<std::size_t> queue{start};
    while (!queue.empty()) {
      const std::size_t node = queue.front();
      queue.pop_front();
      for (const std::size_t next : readers(node)) {
        if (component[next] != component[start] || came_from.contains(next)) continue;
        came_from[next] = node;
        queue.push_back(next);
      }
      if (came_from.contains(start)) break;
    }
    std::vector<std::size_t> path{start};
    for (std::size_t node = came_from[start]; node != start; node = came_from[node]) path.push_back(node);
    std::reverse(path.begin() + 1, path.end());
    return path;
  }

  void refuse(const std::vector<std::size_t>& path) {
    std::string hops;
    const auto hop = [&](std::size_t node) {
      const diagram::DiagramBlock& block = draft_.diagram().blocks[owners_[node].first];
      const yaml::Place place = draft_.diagram().place(block.origin);
      return fmt::format("{} ({}:{})", name(node), place.file, place.mark.line);
    };
    for (std::size_t node : path) hops += hop(node) + " -> ";
    hops += name(path.front());
    const diagram::DiagramBlock& block = draft_.diagram().blocks[owners_[path.front()].first];
    draft_.report.add(
        block.origin, block.name,
        fmt::format("algebraic loop: each of these feeds the next at the same instant: {}; break it with a "
                    "block whose "
                    "output does not follow its input at once (a Lag, an Integrator, a UnitDelay)",
                    hops));
  }

  std::string name(std::size_t node) const {
    const auto& [block, output] = owners_[node];
    const auto& outputs = draft_.type(block).outputs;
    const std::string& block_name = draft_.plan.diagram.blocks[block].name;
    return outputs.size() == 1 ? block_name : block_name + "." + outputs[output].name;
  }

  /// Marks what derivatives need between ticks, and what that needs in turn.
  void mark_stages() {
    std::vector<std::size_t> stack;
    const auto need = [&](const diagram::Source& source) {
      const auto node = node_of(source);
      if (!node) return;
      const std::size_t block = owners_[*node].first;
      if (draft_.blocks[block].in_stages || draft_.plan.blocks[block].rate.kind != Rate::Kind::continuous)
        return;
      draft_.blocks[block].in_stages = true;
      stack.push_back(block);
    };
    const auto need_inputs = [&](std::size_t block) {
      for (const auto& sources : draft_.diagram().blocks[block].inputs)
        for (const diagram::Source& source : sources) need(source);
    };
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b)
      if (draft_.type(b).run_derivatives) need_inputs(b);
    while (!stack.empty()) {
      const std::size_t block = stack.back();
      stack.pop_back();
      need_inputs(block);
    }
  }

  /// Blocks that can share one call: same type, same ticks, both or neither between ticks, both or neither by
  /// the time alone.
  using Group = std::tuple<const BlockType*, int, std::int64_t, bool, bool>;

  Group group(std::size_t block) const {
    const Rate& rate = draft_.plan.blocks[block].rate;
    const Draft::Block& known = draft_.blocks[block];
    return {&draft_.type(block), static_cast<int>(rate.kind), rate.ticks, known.in_stages, known.timed};
  }

  /// How many calls, one waiting for the other, each block begins.
  std::vector<int> heights() const {
    std::vector<int> waiting = waiting_;
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < waiting.size(); ++n)
      if (waiting[n] == 0) order.push_back(n);
    for (std::size_t k = 0; k < order.size(); ++k)
      for (const std::size_t next : readers(order[k]))
        if (--waiting[next] == 0) order.push_back(next);
    std::vector<int> heights(draft_.blocks.size(), 0);
    for (auto n = order.rbegin(); n != order.rend(); ++n)
      for (const std::size_t next : readers(*n))
        heights[owners_[*n].first] = std::max(heights[owners_[*n].first], heights[owners_[next].first] + 1);
    return heights;
  }

  /// Lists blocks so that each comes after what it depends on, as many of one group in a row as can be, and
  /// those first for which the most others wait: a processor works on several calls at once. A block of which
  /// only some outputs can be computed, while nothing else can go on, is listed there and once more later.
  std::vector<int> schedule() {
    heights_ = heights();
    open_nodes_.resize(draft_.blocks.size());
    emitted_.assign(owners_.size(), false);
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b) {
      open_nodes_[b] = node_count(b);
      for (std::size_t n = first_node_[b]; n < first_node_[b + 1]; ++n)
        if (waiting_[n] == 0) node_ready(n);
    }
    while (Bucket* bucket = next_bucket()) {
      while (!bucket->blocks.empty()) {
        const std::size_t block = bucket->blocks.front();
        bucket->blocks.pop_front();
        emit(block);
      }
      bucket->height = 0;
    }
    return std::move(order_);
  }

  /// Blocks of one group that are ready.
  struct Bucket {
    std::deque<std::size_t> blocks;
    int height = 0;  ///< of the highest

    auto rank() const { return std::pair(height, blocks.size()); }
  };

  /// The bucket to go on with; where no block is ready as a whole, one that is in part.
  Bucket* next_bucket() {
    Bucket* best = nullptr;
    for (auto& bucket : buckets_)
      if (!bucket.blocks.empty() && (!best || bucket.rank() > best->rank())) best = &bucket;
    if (best) return best;
    while (!partly_ready_.empty()) {
      const std::size_t node = partly_ready_.front();
      partly_ready_.pop_front();
      if (emitted_[node]) continue;
      emit(owners_[node].first);
      return next_bucket();
    }
    return nullptr;
  }

  void node_ready(std::size_t node) {
    const std::size_t block = owners_[node].first;
    if (--open_nodes_[block] > 0) {
      partly_ready_.push_back(node);
      return;
    }
    const auto [found, added] = bucket_of_.try_emplace(group(block), buckets_.size());
    if (added) buckets_.emplace_back();
    Bucket& bucket = buckets_[found->second];
    bucket.blocks.push_back(block);
    bucket.height = std::max(bucket.height, heights_[block]);
  }

  void emit(std::size_t block) {
    order_.push_back(static_cast<int>(block));
    for (std::size_t n = first_node_[block]; n < first_node_[block + 1]; ++n) {
      if (emitted_[n] || waiting_[n] > 0) continue;
      emitted_[n] = true;
      for (const std::size_t next : readers(n))
        if (--waiting_[next] == 0) node_ready(next);
    }
  }

  Draft& draft_;
  std::vector<std::size_t> first_node_;
  std::vector<std::pair<std::size_t, std::size_t>> owners_;  ///< block and output of each node
  Graph graph_;
  std::vector<int> waiting_;  ///< for each node, how many it still waits for
  std::vector<std::size_t> open_nodes_;
  std::vector<int> heights_;  ///< of blocks
  std::vector<bool> emitted_;
  std::vector<int> order_;
  std::map<Group, std::size_t> bucket_of_;
  std::deque<Bucket> buckets_;  // a deque: growing keeps references valid
  std::deque<std::size_t> partly_ready_;
};

}  // namespace

std::vector<int> plan_order(Draft& draft) {
  return Order(draft).run();
}

}  // namespace stepwire::plan

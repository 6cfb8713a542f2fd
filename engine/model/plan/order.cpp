#include <algorithm>
#include <deque>
#include <map>
#include <optional>

#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/plan/algebraic_loops.hpp"
#include "engine/model/plan/guards.hpp"

namespace stepwire::plan {

namespace {

/// Builds the graph of dependences between outputs and orders the blocks by it.
class Order {
 public:
  explicit Order(Draft& draft) : draft_(draft) {
    for (std::size_t b = 0; b < draft.blocks.size(); ++b) {
      graph_.first.push_back(graph_.owners.size());
      for (std::size_t o = 0; o < draft.type(b).outputs.size(); ++o)
        if (draft.blocks[b].computes) graph_.owners.emplace_back(b, o);
    }
    graph_.first.push_back(graph_.owners.size());
    graph_.edges.resize(graph_.owners.size());
    waiting_.assign(graph_.owners.size(), 0);
    loop_of_.assign(graph_.owners.size(), -1);
    for (std::size_t b = 0; b < draft.blocks.size(); ++b) add_edges(b);
    for (std::size_t b = 0; b < draft.blocks.size(); ++b) add_guard_edges(b);
  }

  CallOrder run() {
    take_loops();
    if (!draft_.report.faults().empty()) return {};
    mark_stages();
    return schedule();
  }

 private:
  struct Loop {
    LoopNodes nodes;
    LoopOrder order;
    std::string path;
    int waiting = 0;  ///< number of outside nodes that it still waits for; -1: emitted
  };

  /// Returns the node that computes a source; std::nullopt for states and constants.
  std::optional<std::size_t> node_of(const diagram::Source& source) const {
    if (source.block < 0) return std::nullopt;
    const auto block = static_cast<std::size_t>(source.block),
               output = static_cast<std::size_t>(source.output);
    if (!draft_.blocks[block].computes || draft_.is_state(block, output)) return std::nullopt;
    return graph_.first[block] + output;
  }

  /// True where a block is always called before another, from an earlier table.
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
        if (const auto from = node_of(source); from && !comes_first(graph_.owners[*from].first, block))
          for (std::size_t o = 0; o < graph_.count(block); ++o)
            if (draft_.depends(block, i, o)) add_edge(*from, graph_.first[block] + o);
  }

  /// Orders a guard before its blocks, and before readers of states that it resets.
  void add_guard_edges(std::size_t block) {
    if (draft_.plan.blocks[block].rate.kind == Rate::Kind::constant) return;
    const auto wait_for = [&](int guard) {
      for (std::size_t n = graph_.first[block]; n < graph_.first[block + 1]; ++n)
        add_edge(graph_.first[static_cast<std::size_t>(guard)], n);
    };
    if (const int guard = draft_.diagram().blocks[block].guard; guard >= 0) wait_for(guard);
    for (const auto& sources : draft_.diagram().blocks[block].inputs)
      for (const diagram::Source& source : sources)
        if (source.block >= 0 && !node_of(source))
          for (const int guard : guards_of(draft_.diagram(), static_cast<std::size_t>(source.block)))
            if (resets(draft_.diagram(), guard)) wait_for(guard);
  }

  void add_edge(std::size_t from, std::size_t to) {
    graph_.edges[from].push_back(to);
    ++waiting_[to];
  }

  void take_loops() {
    for (const LoopNodes& nodes : find_loops(graph_)) {
      const bool decides = std::ranges::any_of(nodes, [&](std::size_t node) {
        return &draft_.type(graph_.owners[node].first) == &diagram::guard_type();
      });
      if (!draft_.diagram().algebraic_loops.solve || decides) {
        refuse_loop(draft_, graph_, nodes);
        continue;
      }
      const int loop = static_cast<int>(loops_.size());
      loops_.push_back({nodes, order_loop(draft_, graph_, nodes), loop_path(draft_, graph_, nodes)});
      for (const std::size_t node : nodes) loop_of_[node] = loop;
    }
    for (Loop& loop : loops_)
      for (const std::size_t node : loop.nodes) loop.waiting += waiting_[node];
    for (std::size_t node = 0; node < graph_.owners.size(); ++node)
      for (const std::size_t reader : graph_.readers(node))
        if (loop_of_[node] >= 0 && loop_of_[node] == loop_of_[reader])
          --loops_[static_cast<std::size_t>(loop_of_[node])].waiting;
  }

  /// Marks the blocks that derivatives depend on between ticks, directly or indirectly.
  void mark_stages() {
    std::vector<std::size_t> stack;
    const auto need = [&](const diagram::Source& source) {
      const auto node = node_of(source);
      if (!node) return;
      const std::size_t block = graph_.owners[*node].first;
      if (draft_.blocks[block].in_stages || draft_.plan.blocks[block].rate.kind != Rate::Kind::continuous)
        return;
      // Steady outputs are constant between events; values beyond the next event must not count.
      if (draft_.is_steady(block)) return;
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

  /// Key of blocks that can share one kernel call: equal type, ticks, use in stages, dependence on time
  /// alone, and guard.
  using Group = std::tuple<const BlockType*, int, std::int64_t, std::int64_t, bool, bool, int>;

  Group group(std::size_t block) const {
    const Rate& rate = draft_.plan.blocks[block].rate;
    const Draft::Block& known = draft_.blocks[block];
    return {&draft_.type(block), static_cast<int>(rate.kind),         rate.ticks, rate.first, known.in_stages,
            known.timed,         draft_.diagram().blocks[block].guard};
  }

  /// Returns for each block the length of the longest chain of dependent calls that it starts.
  std::vector<int> heights() const {
    std::vector<int> waiting = waiting_;
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < waiting.size(); ++n)
      if (waiting[n] == 0) order.push_back(n);
    for (std::size_t k = 0; k < order.size(); ++k)
      for (const std::size_t next : graph_.readers(order[k]))
        if (--waiting[next] == 0) order.push_back(next);
    std::vector<int> heights(draft_.blocks.size(), 0);
    for (auto n = order.rbegin(); n != order.rend(); ++n)
      for (const std::size_t next : graph_.readers(*n))
        heights[graph_.owners[*n].first] =
            std::max(heights[graph_.owners[*n].first], heights[graph_.owners[next].first] + 1);
    return heights;
  }

  /// Orders the blocks topologically (list scheduling over buckets). Ready blocks are collected in one bucket
  /// for each group, so that a kernel call covers many blocks. The bucket with the highest block comes first:
  /// a long chain of dependent calls limits instruction-level parallelism. If no block is ready as a whole, a
  /// solved loop is emitted, else a block of which some outputs are ready; such a block occurs again later.
  CallOrder schedule() {
    heights_ = heights();
    open_nodes_.resize(draft_.blocks.size());
    emitted_.assign(graph_.owners.size(), false);
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b) {
      open_nodes_[b] = graph_.count(b);
      for (std::size_t n = graph_.first[b]; n < graph_.first[b + 1]; ++n)
        if (waiting_[n] == 0 && loop_of_[n] < 0) node_ready(n);
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

  /// Ready blocks of one group.
  struct Bucket {
    std::deque<std::size_t> blocks;
    int height = 0;  ///< largest height of its blocks

    auto rank() const { return std::pair(height, blocks.size()); }
  };

  /// Returns the next bucket; emits a loop or a partly ready block if all buckets are empty.
  Bucket* next_bucket() {
    Bucket* best = nullptr;
    const auto rank = [&](const Bucket& bucket) {
      return std::pair(draft_.diagram().blocks[bucket.blocks.front()].guard == guard_, bucket.rank());
    };
    for (auto& bucket : buckets_)
      if (!bucket.blocks.empty() && (!best || rank(bucket) > rank(*best))) best = &bucket;
    if (best) return best;
    for (Loop& loop : loops_)
      if (loop.waiting == 0) {
        emit_loop(loop);
        return next_bucket();
      }
    while (!partly_ready_.empty()) {
      const std::size_t node = partly_ready_.front();
      partly_ready_.pop_front();
      if (emitted_[node]) continue;
      emit(graph_.owners[node].first);
      return next_bucket();
    }
    return nullptr;
  }

  void node_ready(std::size_t node) {
    const std::size_t block = graph_.owners[node].first;
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

  /// Removes one dependence of a node.
  void release(std::size_t node) {
    const int loop = loop_of_[node];
    --waiting_[node];
    if (loop >= 0)
      --loops_[static_cast<std::size_t>(loop)].waiting;
    else if (waiting_[node] == 0)
      node_ready(node);
  }

  void emit_loop(Loop& loop) {
    loop.waiting = -1;
    const std::size_t first = order_.blocks.size();
    order_.blocks.insert(order_.blocks.end(), loop.order.blocks.begin(), loop.order.blocks.end());
    order_.loops.push_back({first, order_.blocks.size(), {}, loop.path});
    for (const std::size_t node : loop.order.tears)
      order_.loops.back().tears.push_back(
          {static_cast<int>(graph_.owners[node].first), static_cast<int>(graph_.owners[node].second), -1});
    for (const std::size_t node : loop.nodes) emitted_[node] = true;
    for (const std::size_t node : loop.nodes) {
      --open_nodes_[graph_.owners[node].first];
      for (const std::size_t next : graph_.readers(node))
        if (loop_of_[next] != loop_of_[node]) release(next);
    }
  }

  void emit(std::size_t block) {
    order_.blocks.push_back(static_cast<int>(block));
    guard_ = draft_.diagram().blocks[block].guard;
    for (std::size_t n = graph_.first[block]; n < graph_.first[block + 1]; ++n) {
      if (emitted_[n] || waiting_[n] > 0 || loop_of_[n] >= 0) continue;
      emitted_[n] = true;
      for (const std::size_t next : graph_.readers(n)) release(next);
    }
  }

  Draft& draft_;
  OrderGraph graph_;
  std::vector<int> waiting_;  ///< number of nodes that each node still waits for
  std::vector<int> loop_of_;  ///< loop of each node; -1: none
  std::vector<Loop> loops_;
  std::vector<std::size_t> open_nodes_;
  std::vector<int> heights_;  ///< of each block
  std::vector<bool> emitted_;
  CallOrder order_;
  int guard_ = -1;  ///< of the last emitted block: blocks of one guard are skipped together
  std::map<Group, std::size_t> bucket_of_;
  std::deque<Bucket> buckets_;  // a deque: growing keeps references valid
  std::deque<std::size_t> partly_ready_;
};

}  // namespace

CallOrder plan_order(Draft& draft) {
  return Order(draft).run();
}

}  // namespace stepwire::plan

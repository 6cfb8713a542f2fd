// Preparation for splitting steps at crossings.
#include <algorithm>

#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/plan/draft.hpp"
#include "engine/model/plan/guards.hpp"

namespace stepwire::plan {

namespace {

/// Search backwards from inputs. Marks the blocks that must be computed to know these inputs between ticks.
/// It ends at steady and discrete outputs, which do not change there, and at timed ones, which are computed
/// in any case.
class Upstream {
 public:
  Upstream(Draft& draft, bool Draft::Block::*mark) : draft_(draft), mark_(mark) {}

  void need(std::size_t block, std::size_t input) {
    for (const diagram::Source& source : draft_.diagram().blocks[block].inputs[input]) need(source.block);
  }
  void need_all(std::size_t block) {
    for (std::size_t i = 0; i < draft_.diagram().blocks[block].inputs.size(); ++i) need(block, i);
  }
  void need(int source) {
    if (source < 0) return;
    const auto index = static_cast<std::size_t>(source);
    Draft::Block& block = draft_.blocks[index];
    if (block.*mark_ || !block.computes || block.timed || draft_.is_steady(index) ||
        draft_.plan.blocks[index].rate.kind != Rate::Kind::continuous)
      return;
    block.*mark_ = true;
    open_.push_back(index);
  }
  void search() {
    while (!open_.empty()) {
      const std::size_t block = open_.back();
      open_.pop_back();
      need_all(block);
    }
  }

 private:
  Draft& draft_;
  bool Draft::Block::*mark_;
  std::vector<std::size_t> open_;
};

/// Finds the crossing functions, what they depend on, and the blocks that act at every instant.
class EventPlan {
 public:
  explicit EventPlan(Draft& draft) : draft_(draft), upstream_(draft, &Draft::Block::for_crossings) {}

  void run() {
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b)
      if (crosses(b)) add_crossings(b);
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b)
      if (draft_.type(b).run_next_edge && rate(b).kind == Rate::Kind::continuous)
        draft_.plan.edges.push_back(b);
    add_stop();
    upstream_.search();
    bool guards_act = false;
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b)
      guards_act = guards_act || (is_guard(b) && follows(b));
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b) {
      Draft::Block& block = draft_.blocks[b];
      const bool changes = crosses(b) || draft_.type(b).has_continuous_state() || is_triggered(b) ||
                           (draft_.type(b).at_events && !block.says.keeps_to_ticks);
      block.at_events = follows(b) && (block.in_stages || changes || (!has_memory(b) && !samples(b)));
      block.before_guards = guards_act && block.at_events && !is_guard(b);
      block.updates_at_events = block.at_events && changes;
    }
  }

 private:
  const Rate& rate(std::size_t block) const { return draft_.plan.blocks[block].rate; }
  bool has_memory(std::size_t block) const { return draft_.blocks[block].updates || draft_.remembers(block); }

  /// True where the block holds its outputs from tick to tick although it has no states.
  bool samples(std::size_t block) const {
    return draft_.type(block).timing == Timing::discrete && draft_.type(block).states.empty();
  }

  bool is_guard(std::size_t block) const { return &draft_.type(block) == &diagram::guard_type(); }
  /// True where the block is called once for each located edge of a trigger.
  bool is_triggered(std::size_t block) const {
    const auto trigger = static_cast<std::size_t>(diagram::guard_type().input("trigger"));
    return std::ranges::any_of(guards_of(draft_.diagram(), block), [&](int guard) {
      return !draft_.diagram().blocks[static_cast<std::size_t>(guard)].inputs[trigger].empty();
    });
  }

  /// True where a block acts at every instant instead of ticks of its own.
  bool follows(std::size_t block) const {
    if (rate(block).kind == Rate::Kind::continuous) return true;
    return rate(block).kind == Rate::Kind::discrete && rate(block).ticks == 1 &&
           !draft_.plan.diagram.blocks[block].every;
  }
  bool crosses(std::size_t block) const { return draft_.blocks[block].crossings > 0 && follows(block); }

  void add_crossings(std::size_t block) {
    Plan& plan = draft_.plan;
    const auto count = static_cast<std::size_t>(draft_.blocks[block].crossings);
    plan.crossings.push_back({block, plan.crossing_count, count});
    plan.crossing_count += count;
    for (const CrossingSpec& spec : draft_.type(block).crossings)
      for (const std::string& input : spec.inputs)
        upstream_.need(block, static_cast<std::size_t>(draft_.type(block).input(input)));
  }

  /// Adds the crossing of `stop_when`, which has the last number.
  void add_stop() {
    if (!draft_.diagram().stop_when) return;
    draft_.plan.stop_crossing = draft_.plan.crossing_count++;
    for (const diagram::SignalRef& variable : draft_.diagram().stop_when->variables)
      upstream_.need(variable.block);
  }

  Draft& draft_;
  Upstream upstream_;
};

/// Finds the blocks for crossings that can be evaluated ahead, at the end of a step before the tick there. No
/// discrete block, guard or external input may influence them. Blocks whose outputs at a tick differ from
/// those before it are computed at the tick. All candidates are marked first; those with an input that is not
/// available ahead are unmarked until no mark changes.
class AheadBlocks {
 public:
  AheadBlocks(Draft& draft, const CallOrder& order) : draft_(draft), order_(order) {}

  void run() {
    std::vector<int> calls(draft_.blocks.size(), 0);
    for (const int block : order_.blocks) ++calls[static_cast<std::size_t>(block)];
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b)
      draft_.blocks[b].ahead = draft_.blocks[b].for_crossings && !draft_.blocks[b].differs_at_instants &&
                               calls[b] == 1 && draft_.diagram().blocks[b].guard < 0;
    while (take_back()) continue;
  }

 private:
  /// Unmarks blocks that depend on a block that is not ahead; returns false once no mark changes.
  bool take_back() {
    bool taken = false;
    const auto take = [&](std::size_t block) {
      taken = taken || draft_.blocks[block].ahead;
      draft_.blocks[block].ahead = false;
    };
    for (const int b : order_.blocks)
      if (!reads_ahead(static_cast<std::size_t>(b))) take(static_cast<std::size_t>(b));
    for (const CallOrder::Loop& loop : order_.loops)  // all blocks of a loop or none
      if (!std::all_of(member(loop.first), member(loop.end), [&](int b) { return is_ahead(b); }))
        std::for_each(member(loop.first), member(loop.end),
                      [&](int b) { take(static_cast<std::size_t>(b)); });
    return taken;
  }
  std::vector<int>::const_iterator member(std::size_t place) const {
    return order_.blocks.begin() + static_cast<std::ptrdiff_t>(place);
  }
  bool is_ahead(int block) const { return draft_.blocks[static_cast<std::size_t>(block)].ahead; }

  bool reads_ahead(std::size_t block) const {
    for (const auto& sources : draft_.diagram().blocks[block].inputs)
      if (!std::ranges::all_of(sources, [&](const diagram::Source& source) { return stands(source); }))
        return false;
    return true;
  }
  /// True where the source is known at the end of a step, independent of the tick there.
  bool stands(const diagram::Source& source) const {
    if (source.block < 0 || is_ahead(source.block)) return true;
    const auto block = static_cast<std::size_t>(source.block);
    if (draft_.blocks[block].timed || draft_.plan.blocks[block].rate.kind == Rate::Kind::constant)
      return true;
    return draft_.is_state(block, static_cast<std::size_t>(source.output)) &&
           !is_reset(draft_.diagram(), block);
  }

  Draft& draft_;
  const CallOrder& order_;
};

/// True where a block may end the run as `stop_when` does: its last row is then computed again.
bool may_end(const Draft& draft) {
  const auto ends = [](const DiagnosticSpec& spec) { return spec.ends_run && !spec.is_fault; };
  for (std::size_t b = 0; b < draft.blocks.size(); ++b)
    if (std::ranges::any_of(draft.type(b).diagnostics, ends)) return true;
  return false;
}

/// Marks blocks whose outputs change between instants. Guards change only at instants.
void find_sides(Draft& draft) {
  for (std::size_t b = 0; b < draft.blocks.size(); ++b)
    draft.blocks[b].on_sides = draft.blocks[b].computes && !draft.is_steady(b) &&
                               draft.plan.blocks[b].rate.kind == Rate::Kind::continuous &&
                               &draft.type(b) != &diagram::guard_type();
}

/// Marks what an external solver computes between instants: all but outputs that are constant there.
void find_between(Draft& draft) {
  for (std::size_t b = 0; b < draft.blocks.size(); ++b)
    draft.blocks[b].between =
        draft.blocks[b].computes && !(draft.is_steady(b) && draft.blocks[b].crossings > 0);
}

void find_lefts(Draft& draft) {
  Upstream upstream(draft, &Draft::Block::for_left);
  for (std::size_t b = 0; b < draft.blocks.size(); ++b)
    if (draft.blocks[b].updates_before_instant) upstream.need_all(b);
  upstream.search();
}

}  // namespace

void find_events(Draft& draft, const CallOrder& order) {
  find_lefts(draft);
  if (draft.plan.records_instants() || may_end(draft)) find_sides(draft);
  if (!draft.diagram().events.locate) return;
  EventPlan(draft).run();
  find_between(draft);
  if (!draft.plan.jumps) AheadBlocks(draft, order).run();
}

}  // namespace stepwire::plan

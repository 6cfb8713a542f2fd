// What is needed to split steps at crossings.
#include <algorithm>

#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

namespace {

/// Finds what crosses, and what follows at every instant.
class EventPlan {
 public:
  explicit EventPlan(Draft& draft) : draft_(draft) {}

  void run() {
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b)
      if (crosses(b)) add_crossings(b);
    while (!open_.empty()) {
      const std::size_t block = open_.back();
      open_.pop_back();
      for (const auto& sources : draft_.diagram().blocks[block].inputs)
        for (const diagram::Source& source : sources) need(source);
    }
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b) {
      Draft::Block& block = draft_.blocks[b];
      block.at_events = follows(b) && (block.in_stages || crosses(b) || !has_memory(b) ||
                                       draft_.type(b).has_continuous_state());
    }
  }

 private:
  const Rate& rate(std::size_t block) const { return draft_.plan.blocks[block].rate; }
  bool has_memory(std::size_t block) const {
    return draft_.blocks[block].updates || !draft_.type(block).states.empty();
  }

  /// Does a block act whenever something happens, not at ticks of its own?
  bool follows(std::size_t block) const {
    // What it guards is held, reset and kept at ticks alone.
    if (&draft_.type(block) == &diagram::guard_type()) return false;
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
    open_.push_back(block);
  }

  void need(const diagram::Source& source) {
    if (source.block < 0) return;
    const auto index = static_cast<std::size_t>(source.block);
    Draft::Block& block = draft_.blocks[index];
    if (block.for_crossings || !block.computes || block.timed || rate(index).kind != Rate::Kind::continuous ||
        draft_.type(index).steady)
      return;
    block.for_crossings = true;
    open_.push_back(index);
  }

  Draft& draft_;
  std::vector<std::size_t> open_;
};

}  // namespace

void find_events(Draft& draft) {
  if (draft.diagram().events.locate) EventPlan(draft).run();
}

}  // namespace stepwire::plan

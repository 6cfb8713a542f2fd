#include <algorithm>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

namespace {

/// Marks all blocks that may depend on time alone, then unmarks those that depend on other blocks.
class TimedBlocks {
 public:
  explicit TimedBlocks(Draft& draft) : draft_(draft), readers_(draft.blocks.size()) {
    for (std::size_t b = 0; b < draft.blocks.size(); ++b) {
      draft.blocks[b].timed = may_be_timed(b);
      for (const auto& sources : draft.diagram().blocks[b].inputs)
        for (const diagram::Source& source : sources)
          if (source.block >= 0) readers_[static_cast<std::size_t>(source.block)].push_back(b);
    }
  }

  void run() {
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b) check(b);
    while (!refused_.empty()) {
      const std::size_t block = refused_.back();
      refused_.pop_back();
      for (const std::size_t reader : readers_[block]) check(reader);
    }
  }

 private:
  bool is_constant(std::size_t block) const {
    return draft_.plan.blocks[block].rate.kind == Rate::Kind::constant;
  }

  bool may_be_timed(std::size_t block) const {
    return draft_.blocks[block].computes && !draft_.blocks[block].differs_at_instants &&
           !draft_.remembers(block) && draft_.diagram().blocks[block].guard < 0 &&
           draft_.plan.blocks[block].rate.kind == Rate::Kind::continuous && !draft_.is_steady(block);
  }

  bool is_timed(const diagram::Source& source) const {
    if (source.block < 0) return true;
    const auto block = static_cast<std::size_t>(source.block);
    return draft_.blocks[block].timed || is_constant(block);
  }

  void check(std::size_t block) {
    if (!draft_.blocks[block].timed) return;
    for (const auto& sources : draft_.diagram().blocks[block].inputs)
      for (const diagram::Source& source : sources)
        if (!is_timed(source)) draft_.blocks[block].timed = false;
    if (!draft_.blocks[block].timed) refused_.push_back(block);
  }

  Draft& draft_;
  std::vector<std::vector<std::size_t>> readers_;  ///< readers of each block
  std::vector<std::size_t> refused_;               ///< whose readers are not yet unmarked
};

}  // namespace

namespace {

/// Determines whether an output may jump by time alone. Blocks with a clock may, and blocks that read only
/// such blocks and constants, unless they are smooth.
class Jumps {
 public:
  explicit Jumps(const Draft& draft) : draft_(draft), follows_time_(draft.blocks.size(), false) {}

  bool run() {
    while (find_more()) continue;
    for (std::size_t b = 0; b < follows_time_.size(); ++b)
      if (follows_time_[b] && !is_smooth(b)) return true;
    return false;
  }

 private:
  bool is_smooth(std::size_t block) const {
    return draft_.type(block).smooth || draft_.blocks[block].says.smooth;
  }

  bool find_more() {
    bool found = false;
    for (std::size_t b = 0; b < follows_time_.size(); ++b)
      if (!follows_time_[b] && follows_time(b)) found = follows_time_[b] = true;
    return found;
  }

  bool follows_time(std::size_t block) const {
    const Rate::Kind kind = draft_.plan.blocks[block].rate.kind;
    if (kind != Rate::Kind::continuous || !draft_.blocks[block].computes) return false;
    const auto& clocks = draft_.type(block).clocks;
    // Smooth blocks with inputs have a clock for their diagnostics.
    bool time =
        std::ranges::any_of(clocks, [](const ClockSpec& clock) { return clock.bind_time != nullptr; });
    if (time && !is_smooth(block)) return true;
    for (const auto& sources : draft_.plan.diagram.blocks[block].inputs)
      for (const diagram::Source& source : sources) {
        if (source.block < 0) continue;
        const auto from = static_cast<std::size_t>(source.block);
        if (!follows_time_[from] && draft_.plan.blocks[from].rate.kind != Rate::Kind::constant) return false;
        time = time || follows_time_[from];
      }
    return time;
  }

  const Draft& draft_;
  std::vector<bool> follows_time_;
};

}  // namespace

void find_timed(Draft& draft) {
  TimedBlocks(draft).run();
  draft.plan.jumps = !draft.diagram().solver.empty() && Jumps(draft).run();
}

}  // namespace stepwire::plan

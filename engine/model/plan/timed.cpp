#include <algorithm>

#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

namespace {

/// Takes every block for timed that may be, and then back what depends on what is not.
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
    return draft_.blocks[block].computes && draft_.type(block).states.empty() &&
           draft_.diagram().blocks[block].guard < 0 &&
           draft_.plan.blocks[block].rate.kind == Rate::Kind::continuous &&
           !(draft_.type(block).steady && draft_.diagram().events.locate);
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
  std::vector<std::vector<std::size_t>> readers_;  ///< of each block
  std::vector<std::size_t> refused_;               ///< whose readers have not been told
};

}  // namespace

void find_timed(Draft& draft) {
  TimedBlocks(draft).run();
}

}  // namespace stepwire::plan

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/simulate/run/bound_blocks.hpp"
#include "engine/simulate/run/guards.hpp"
#include "engine/simulate/run/schedule_probe.hpp"

namespace stepwire::run {

/// Blocks that take part at the present instant: by periods that are due, and by guards.
struct Participants {
  explicit Participants(BoundBlocks& blocks) : due(blocks.plan().periods.size(), 1), blocks_(blocks) {
    if (!blocks.plan().guards.empty())
      guards.emplace(blocks.plan(), blocks.values(), [&blocks](std::size_t block) { blocks.start(block); });
  }

  void find_due(std::int64_t tick) {
    const std::vector<plan::Period>& periods = blocks_.plan().periods;
    for (std::size_t i = 1; i < due.size(); ++i) due[i] = periods[i].due(tick);
  }
  /// Keeps what a guard puts back once it switches off.
  void keep() {
    if (guards) guards->keep();
  }

  std::vector<char> due;           ///< for each of the plan's periods
  std::optional<Guards> guards;    ///< none where the plan has none
  ScheduleProbe* probe = nullptr;  ///< told of a stretch of calls; null where there is none

 private:
  BoundBlocks& blocks_;
};

}  // namespace stepwire::run

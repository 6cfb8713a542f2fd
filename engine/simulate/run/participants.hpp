#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/simulate/run/bound_blocks.hpp"
#include "engine/simulate/run/guards.hpp"
#include "engine/simulate/run/schedule_probe.hpp"

namespace stepwire::run {

/// Blocks that are active at the present instant: by due periods, and by guards.
struct Participants {
  explicit Participants(BoundBlocks& blocks) : due(blocks.plan().periods.size(), 1), blocks_(blocks) {
    if (!blocks.plan().guards.empty())
      guards.emplace(blocks.plan(), blocks.values(), [&blocks](std::size_t block) { blocks.start(block); });
  }

  void find_due(std::int64_t tick) {
    const std::vector<plan::Period>& periods = blocks_.plan().periods;
    for (std::size_t i = 1; i < due.size(); ++i) due[i] = periods[i].due(tick);
  }
  /// Stores the numbers that a guard restores once it switches off.
  void keep() {
    if (guards) guards->keep();
  }

  std::vector<char> due;           ///< one flag for each period of the plan
  std::optional<Guards> guards;    ///< std::nullopt in a plan without guards
  ScheduleProbe* probe = nullptr;  ///< measures a range of calls; nullptr if unused

 private:
  BoundBlocks& blocks_;
};

}  // namespace stepwire::run

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/simulate/realtime/counter.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::realtime {

/// Cost of the blocks of one type in a tick.
struct GroupCost {
  std::string type;
  std::size_t blocks = 0;
  double mean = 0.0;         ///< sum of the means of its call ranges [ns]
  std::int64_t samples = 0;  ///< of all its call ranges
};

/// Samples the cost of block types while a loop runs, at the price of two clock readings per wake-up.
///
/// The calls of a tick are divided into ranges of one type. At each wake-up one range is timed in the first
/// tick. A fixed pseudo-random sequence selects it, since a cyclic order would hit blocks of slower rates
/// always or never. One range is empty: it measures the cost of the clock readings, which is subtracted from
/// the others.
class GroupCosts : private run::ScheduleProbe {
 public:
  GroupCosts(const plan::Plan& plan, LoopClock& clock);

  /// Call these before and after the first tick of a wake-up.
  void before_tick(run::Executor& simulation);
  void after_tick(run::Executor& simulation);

  /// Returns the costs, largest first. Thread-safe.
  std::vector<GroupCost> costs() const;

 private:
  struct Stretch {
    const std::vector<plan::KernelCall>* phase;
    std::size_t first, end;
    std::size_t group;
    Counter samples{}, looks{}, spent{};  ///< ticks; executions in them; time [ns]
  };
  double cost_of_look() const;
  void cut(const plan::Plan& plan, const std::vector<plan::KernelCall>& phase);
  void enter() override;
  void leave() override;

  LoopClock& clock_;
  std::vector<GroupCost> groups_;
  std::vector<Stretch> stretches_;  ///< the first one is the empty range
  std::uint64_t sequence_ = 1;
  Stretch* now_ = nullptr;
  bool ran_ = false;  ///< true if the range ran in this tick; false in code without a table of calls
  std::int64_t entered_ = 0;
};

}  // namespace stepwire::realtime

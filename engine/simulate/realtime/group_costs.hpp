#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/simulate/realtime/counter.hpp"
#include "engine/simulate/realtime/loop_clock.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::realtime {

/// What the blocks of one type cost in a tick.
struct GroupCost {
  std::string type;
  std::size_t blocks = 0;
  double mean = 0.0;         ///< [ns]; the sum of its stretches' means
  std::int64_t samples = 0;  ///< of all its stretches
};

/// Samples what block types cost while a loop runs, without measuring each of them all the time: the calls of
/// a tick are cut into stretches of one type, and at each wake-up the first tick's time in one of them is
/// taken by looks at the clock. Which one is chosen by a fixed pseudo-random sequence, since turns in order
/// would meet blocks of slower rates always or never. An empty stretch is among them: what looking costs by
/// itself is taken off the others.
class GroupCosts : private run::ScheduleProbe {
 public:
  GroupCosts(const plan::Plan& plan, LoopClock& clock);

  /// Around the first tick of a wake-up.
  void before_tick(run::Executor& simulation);
  void after_tick(run::Executor& simulation);

  /// The dearest first. From any thread.
  std::vector<GroupCost> costs() const;

 private:
  struct Stretch {
    const std::vector<plan::KernelCall>* phase;
    std::size_t first, end;
    std::size_t group;
    Counter samples{}, looks{}, spent{};  ///< ticks; times that it ran in them; [ns]
  };
  double cost_of_look() const;
  void cut(const plan::Plan& plan, const std::vector<plan::KernelCall>& phase);
  void enter() override;
  void leave() override;

  LoopClock& clock_;
  std::vector<GroupCost> groups_;
  std::vector<Stretch> stretches_;  ///< the first is the empty one
  std::uint64_t sequence_ = 1;
  Stretch* now_ = nullptr;
  bool ran_ = false;  ///< in this tick; not where the simulation does without the table of calls
  std::int64_t entered_ = 0;
};

}  // namespace stepwire::realtime

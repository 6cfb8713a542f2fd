#pragma once

#include <array>
#include <atomic>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/profile/stopwatch.hpp"
#include "engine/simulate/run/loop_cost.hpp"

namespace stepwire::profile {

/// What a block is called for: outputs by the time alone, other outputs at ticks, those at the solver's
/// stages between ticks, derivatives, updates.
inline constexpr std::size_t phase_count = 5;
inline constexpr std::array<const char*, phase_count> phase_names{"timed", "outputs", "stages", "derivatives",
                                                                  "updates"};

/// Calls in a whole run, and what they take together.
struct Cost {
  std::int64_t calls = 0;
  double seconds = 0.0;

  Cost& operator+=(const Cost& other);
};

/// What a block, or all that is inside of a part, takes in a whole run.
struct BlockCost {
  std::string name, type;  ///< the type of a part is "part"
  bool part = false;
  std::array<Cost, phase_count> phases{};

  Cost total() const;
  /// Of the block alone [s]: a part does nothing itself.
  double self() const { return part ? 0.0 : total().seconds; }
};

/// What a run does beside calling blocks: the solver's own arithmetic, the check that all is finite,
/// recording, the stop condition.
struct RunCost {
  std::string name;
  Cost cost;
};

/// Where the time of a run goes.
struct Profile {
  std::int64_t ticks = 0;
  double seconds = 0.0;  ///< of all its steps; taking memory for what is recorded, and keeping it, is extra
  std::vector<BlockCost> blocks;  ///< and parts; the most expensive first
  std::vector<RunCost> others;
  std::vector<run::LoopCost> loops;  ///< algebraic ones: their blocks are called more often than counted here

  double share(double part) const { return seconds > 0.0 ? part / seconds : 0.0; }
  /// What is in none of the other numbers [s]: going through the tables of calls, waiting of one table for
  /// what another has just computed, and errors of measuring, by which it may be below 0.
  double left() const;
};

struct ProfileOptions {
  ClockReader clock;
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, what has been run so far is the whole
};

/// Measures a run of its own, interpreted.
///
/// A call of a block takes a tenth of what reading a clock does, so no call is timed alone. The run is cut
/// into up to 64 segments. Each is run three times from the same moment, and the shortest times add up to the
/// time of the whole run. At the start of each segment the tables of calls are timed at three levels, each
/// time many calls in a row: a whole table, which has the blocks among their neighbours; each call of the
/// table, and each block of a call, alone. What a table takes is parted among its calls, and what a call
/// takes among its blocks, in proportion to what they take alone, and multiplied with the number of calls in
/// the run, which is known. Outputs and derivatives may be repeated; updates change states, so the moment is
/// restored behind them. What reading the clock adds is taken off. The solver's own arithmetic is timed on
/// equations that cost nothing.
Profile profile_plan(const plan::Plan& plan, const ProfileOptions& options);

}  // namespace stepwire::profile

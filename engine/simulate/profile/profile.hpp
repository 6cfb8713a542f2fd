#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/loop_cost.hpp"

namespace stepwire::profile {

/// Reads a monotonic clock [s].
using ClockReader = std::function<double()>;

/// Measures actions that may be shorter than a reading of the clock. The shortest of several tries is used,
/// since other load only lengthens a time.
class Stopwatch {
 public:
  explicit Stopwatch(ClockReader read) : read_(std::move(read)) {
    const auto nothing = [] {};
    cost_ = shortest(
        64, [] {}, nothing);
  }

  /// Returns the time that reading the clock adds [s].
  double cost() const { return cost_; }

  /// Returns the time of an action [s], the shortest of `tries`. `prepare` is called before each try and is
  /// not timed.
  template <class Prepare, class Action>
  double shortest(int tries, const Prepare& prepare, const Action& action) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tries; ++i) {
      prepare();
      const double start = read_();
      action();
      least = std::min(least, read_() - start);
    }
    return std::max(0.0, least - cost_);
  }

  /// Returns the time of an action that may be repeated [s]: the mean of as many repetitions as take `aim`
  /// seconds.
  template <class Action>
  double repeated(double aim, const Action& action) const {
    const auto nothing = [] {};
    const double single = shortest(1, nothing, action);
    const int count = static_cast<int>(std::clamp(aim / std::max(single, 1e-9), 1.0, max_repeats));
    const double together = shortest(2, nothing, [&] {
      for (int i = 0; i < count; ++i) action();
    });
    return count == 1 ? std::min(single, together) : together / count;
  }

 private:
  static constexpr double max_repeats = 100.0;

  ClockReader read_;
  double cost_ = 0.0;  ///< [s]
};

/// Phases in which blocks are called: time-dependent outputs, other outputs at ticks, outputs at the solver's
/// stages between ticks, derivatives, updates.
inline constexpr std::size_t phase_count = 5;
inline constexpr std::array<const char*, phase_count> phase_names{"timed", "outputs", "stages", "derivatives",
                                                                  "updates"};

/// Number of calls in a whole run, and their total time.
struct Cost {
  std::int64_t calls = 0;
  double seconds = 0.0;

  Cost& operator+=(const Cost& other);
};

/// Cost of a block in a whole run, or of all blocks in a part.
struct BlockCost {
  std::string name, type;  ///< the type of a part is "part"
  bool part = false;
  std::array<Cost, phase_count> phases{};

  Cost total() const;
  /// Returns the time of the block itself [s]; 0 for a part.
  double self() const { return part ? 0.0 : total().seconds; }
};

/// Cost of a run outside of blocks: the solver's own arithmetic, the check for non-finite numbers, recording,
/// the stop condition.
struct RunCost {
  std::string name;
  Cost cost;
};

/// Distribution of the time of a run.
struct Profile {
  std::int64_t ticks = 0;
  double seconds = 0.0;           ///< Time of all steps, without the memory of recordings.
  std::vector<BlockCost> blocks;  ///< Blocks and parts; the most expensive first.
  std::vector<RunCost> others;
  std::vector<run::LoopCost> loops;  ///< Algebraic loops, whose repeated calls are not counted here.

  double share(double part) const { return seconds > 0.0 ? part / seconds : 0.0; }
  /// Returns the time [s] that is in none of the other numbers. It contains the overhead of the tables of
  /// calls, cache effects between tables, and measurement errors, which may make it negative.
  double left() const;
};

struct ProfileOptions {
  ClockReader clock;
  const std::atomic<bool>* interrupt = nullptr;  ///< flag that ends the profile with what has been run so far
};

/// Measures a run of its own, interpreted.
///
/// A call of a block takes a tenth of a clock reading, so no call can be timed alone. The run is divided into
/// up to 64 segments. Each is run three times from the same snapshot, and the sum of the shortest times is
/// the time of the run.
///
/// At the start of each segment the tables of calls are timed at three levels. These are a whole table, each
/// call of the table alone, and each block of a call alone, many times in a row. The time of a table, in
/// which the blocks run among their neighbours, is divided among its calls in proportion to their times
/// alone. The time of a call is divided among its blocks in the same way. The results are multiplied by the
/// known number of calls.
///
/// Outputs and derivatives may be repeated. Updates change states, so the snapshot is restored after them.
/// The cost of reading the clock is subtracted. The solver's own arithmetic is timed on equations without
/// cost.
Profile profile_plan(const plan::Plan& plan, const ProfileOptions& options);

}  // namespace stepwire::profile

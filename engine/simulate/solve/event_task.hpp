#pragma once

#include <cstddef>
#include <cstdint>

namespace stepwire::solve {

/// What is known of located events in a run: numbers of the workspace, in this order.
struct EventReport {
  static constexpr std::size_t events = 0;   ///< crossings all together
  static constexpr std::size_t most = 1;     ///< in one step
  static constexpr std::size_t end = 2;      ///< why the run ends there, else 0
  static constexpr std::size_t number = 3;   ///< which crossing was the last one then, or which place changes
  static constexpr std::size_t ahead = 4;    ///< 1 where outputs of the next tick are computed
  static constexpr std::size_t stopped = 5;  ///< 1 once the run has ended at one
  static constexpr std::size_t count = 6;

  /// Values of `end`.
  static constexpr double too_many = 1.0, ever_faster = 2.0, unsettled = 3.0;
};

/// A step that is split at events. Offsets are places in the workspace. The scratch memory begins with the
/// states at the start of the step; the crossings there lie at `before`.
struct EventTask {
  std::size_t time, states, derivatives, state_count;
  std::size_t crossing_count;
  std::size_t first, numbers;  ///< signals and states, also discrete ones
  std::size_t report;          ///< where an EventReport lies
  bool jumps;                  ///< a source may jump: the end of a step is seen just before it
  bool branches;               ///< a block may take another branch within a stage
  std::int64_t max_per_step;   ///< beyond, the step is given up
  std::int64_t rounds;         ///< beyond, an instant is
  std::int64_t looks;          ///< between two events, for what crosses twice
  bool looks_always;           ///< also where no number comes near to 0
  double* scratch;             ///< scratch_size() numbers

  static constexpr std::size_t scratch_size(std::size_t states, std::size_t crossings, std::size_t numbers) {
    return 3 * states + 10 * crossings + numbers;  // as EventLocator lays it out
  }
  static constexpr std::size_t before(std::size_t states) { return 2 * states; }
};

}  // namespace stepwire::solve

#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/simulate/solve/loop_guesses.hpp"

namespace stepwire::solve {

/// State of event location, as indices into numbers of the workspace.
struct EventReport {
  static constexpr std::size_t events = 0;   ///< Total number of crossings.
  static constexpr std::size_t most = 1;     ///< Largest number in one step.
  static constexpr std::size_t end = 2;      ///< Reason why the run ends; 0 otherwise.
  static constexpr std::size_t number = 3;   ///< Last crossing, or changing place, at that end.
  static constexpr std::size_t ahead = 4;    ///< 1 if outputs of the next tick are computed.
  static constexpr std::size_t stopped = 5;  ///< 1 once the run has ended at an event.
  static constexpr std::size_t count = 6;

  /// Values of `end`.
  static constexpr double too_many = 1.0, ever_faster = 2.0, unsettled = 3.0;
};

/// Step that is split at events. Offsets are places in the workspace. The scratch memory begins with the
/// states at the start of the step; the crossing functions there are at `before`, the guesses of loops at
/// `guesses`.
struct EventTask {
  std::size_t time, states, derivatives, state_count;
  std::size_t crossing_count;
  std::size_t first, numbers;  ///< Range of signals and states, also discrete ones.
  std::size_t report;          ///< Place of the EventReport.
  bool jumps;                  ///< True if sources may jump; a step then ends just before the jump.
  std::int64_t max_per_step;   ///< Limit of events in a step; beyond it the run ends.
  std::int64_t rounds;         ///< Limit of iterations at an instant.
  std::int64_t looks;          ///< Inner points that are checked for double crossings.
  bool looks_always;           ///< True if they are always checked.
  LoopGuesses loops;           ///< Of the solved loops; their tolerance is noise of crossing functions.
  std::size_t control, control_count;  ///< Range of the numbers of a solver's error control.
  double* scratch;                     ///< Memory for scratch_size() numbers.

  static constexpr std::size_t scratch_size(std::size_t states, std::size_t crossings, std::size_t numbers,
                                            std::size_t control, std::size_t guesses) {
    return 3 * states + 13 * crossings + numbers + control + 2 * guesses;  // layout of EventLocator
  }
  std::size_t guesses() const { return scratch_size(state_count, crossing_count, numbers, control_count, 0); }
  static constexpr std::size_t before(std::size_t states) { return 2 * states; }
};

}  // namespace stepwire::solve

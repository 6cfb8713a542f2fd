#pragma once

#include <cstdint>

namespace stepwire::plan {

/// Input and output of code that steps a lane batch.
struct LaneTask {
  /// Reasons for the end of a run in a tick.
  enum How : int {
    evaluated,  ///< A number is possibly not finite: the recording ends before this tick.
    last,       ///< At its stop time or by `stop_when`: this tick is the last one.
    advanced    ///< By a diagnostic that ends the run, after this tick.
  };

  double* values;         ///< Workspaces: number n of lane l is at n * lanes + l.
  const double* numbers;  ///< Tables of numbers in the same layout; the lists follow all of them.
  std::int64_t tick;      ///< Tick of the next outputs.
  std::int64_t end;       ///< Tick before which the call returns; its outputs are not computed.
  std::int64_t stop;      ///< Tick at which all runs end.
  std::uint32_t active;   ///< Bit l: lane l is an active run.
  double** rows;  ///< For each record request the next row to write; all lanes of a number are adjacent.
  /// Removes runs, given as a bit mask. Called once for each tick at which runs end.
  void (*leave)(LaneTask& task, std::uint32_t lanes, int how);
  void* owner;
};

}  // namespace stepwire::plan

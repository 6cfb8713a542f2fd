#pragma once

#include <cstdint>

namespace stepwire::plan {

/// What code that steps several runs of a plan together is given, and what it gives back.
struct LaneTask {
  /// How a run may end in a tick.
  enum How : int {
    evaluated,  ///< it may, by a number that is not finite: what is recorded ends before this tick
    last,       ///< at its stop time or by `stop_when`: this tick is the last one
    advanced    ///< by a diagnostic that ends it, after this tick
  };

  double* values;         ///< workspaces: number n of lane l at n * lanes + l
  const double* numbers;  ///< tables of numbers, alike; lists behind all of them
  std::int64_t tick;      ///< of the next outputs
  std::int64_t end;       ///< goes on until this tick, whose outputs are not computed
  std::int64_t stop;      ///< tick at which all end
  std::uint32_t active;   ///< bit l: lane l is a run that goes on
  double** rows;  ///< of each request to record: where its next row goes, all lanes of a number side by side
  /// Takes runs out, by their bits: once for each tick at which some end.
  void (*leave)(LaneTask& task, std::uint32_t lanes, int how);
  void* owner;
};

}  // namespace stepwire::plan

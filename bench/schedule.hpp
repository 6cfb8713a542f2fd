#pragma once

#include <cstddef>

namespace schedule {

/// Costs of running items in other processes [s].
struct Costs {
  double answer = 0.0;   ///< Answer to a message, including both copies between network and memory.
  double item = 0.0;     ///< Storage of the result of one run.
  double latency = 0.0;  ///< Latency between two processes; no processor is busy.
};

/// Rule for the number of runs in one group.
enum class Rule {
  by_number,  ///< A quarter of each process' share of the remaining runs, at most 1000.
  by_time     ///< The rule of `stepwire --mpi`.
};

/// A sweep over processes, one of which collects and writes the results.
struct Case {
  std::size_t ranks = 2,
              parts = 1;  ///< Number of all processes, and of separate calls of `--part` that share them.
  double run = 1.0;       ///< Mean duration of a run [s]; each takes 0.5 to 1.5 times this.
  double runs = 1e6;      ///< Number of runs of the sweep.
  Rule rule = Rule::by_time;
};

/// Result of a simulated sweep.
struct Outcome {
  double efficiency = 0.0;  ///< Efficiency of all processes, including those that write.
  double busy = 0.0;        ///< Share of the time in which the writing process is busy.
};

/// Simulates a sweep. The result is deterministic.
Outcome simulate(const Case& of, const Costs& costs);

}  // namespace schedule

#pragma once

#include <cstddef>

namespace schedule {

/// What it costs to have runs done by other processes [s].
struct Costs {
  double answer = 0.0;   ///< to answer a message, with its way from and to a process's memory
  double item = 0.0;     ///< to keep what a run gave
  double latency = 0.0;  ///< from a process to another, in which no processor works
};

/// How many runs a process is given at once.
enum class Rule {
  by_number,  ///< a quarter of what is left for each, 1000 at most
  by_time     ///< as `stepwire --mpi` does
};

/// A sweep by processes of which one keeps and writes.
struct Case {
  std::size_t ranks = 2, parts = 1;  ///< processes in all, in so many calls of `--part` of their own
  double run = 1.0;                  ///< mean length of a run [s]; each is from half to one and a half of it
  double runs = 1e6;                 ///< of the sweep
  Rule rule = Rule::by_time;
};

/// What became of it.
struct Outcome {
  double efficiency = 0.0;  ///< of all processes, also those that write
  double busy = 0.0;        ///< share of the time in which the one that writes is at work
};

/// The same numbers each time.
Outcome simulate(const Case& of, const Costs& costs);

}  // namespace schedule

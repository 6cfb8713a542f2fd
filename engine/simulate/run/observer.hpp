#pragma once

#include <cstddef>
#include <span>

#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/flow.hpp"

namespace stepwire::run {

/// Run that an observer watches.
struct ObservedRun {
  /// Index among the runs of a sweep. For trials of a study the order is by study of the sweep, subject and
  /// condition. 0 for a single run and a real-time loop.
  std::size_t index;
  Executor& simulation;
};

/// Observer of runs while they are computed. Each run calls from its own thread, so calls for several runs of
/// a sweep may be concurrent. A run waits for each call.
class RunObserver {
 public:
  virtual ~RunObserver() = default;

  /// Called before the first tick.
  virtual void begin(const ObservedRun&) {}
  /// Called before every tick. Here an observer may write inputs, set values, and take or restore snapshots.
  /// After a restore, the later rows are recorded again.
  virtual Flow before_tick(const ObservedRun&) { return Flow::go_on; }
  /// Called after the outputs of a tick are computed.
  virtual void evaluated(const ObservedRun&) {}
  /// Called with a row of the entry `recording` of `record`: the time, then its signals.
  virtual void row(const ObservedRun&, std::size_t /*recording*/, std::span<const double> /*numbers*/) {}
  /// Called after the last tick, after any kind of end.
  virtual void end(const ObservedRun&) {}
};

}  // namespace stepwire::run

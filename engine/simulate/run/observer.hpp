#pragma once

#include <cstddef>
#include <span>

#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/flow.hpp"

namespace stepwire::run {

/// A run as it is shown to observers.
struct ObservedRun {
  /// Among the runs of a sweep; of a study's trials by study of a sweep, subject and condition. 0 for a
  /// single run and a real-time loop.
  std::size_t index;
  Executor& simulation;
};

/// Watches runs while they are computed. Each run calls from its own thread, so that calls for several runs
/// of a sweep may come at the same time. A run waits for each call.
class RunObserver {
 public:
  virtual ~RunObserver() = default;

  /// Before the first tick.
  virtual void begin(const ObservedRun&) {}
  /// Before every tick: here inputs are written, values set, moments kept and restored; what was recorded
  /// from a restored moment on is recorded anew.
  virtual Flow before_tick(const ObservedRun&) { return Flow::go_on; }
  /// After the outputs of a tick are computed.
  virtual void evaluated(const ObservedRun&) {}
  /// A row that is recorded by the entry `recording` of `record`: the time, then its signals.
  virtual void row(const ObservedRun&, std::size_t /*recording*/, std::span<const double> /*numbers*/) {}
  /// After the last tick, whatever ended the run.
  virtual void end(const ObservedRun&) {}
};

}  // namespace stepwire::run

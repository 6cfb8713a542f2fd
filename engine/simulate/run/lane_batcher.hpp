#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

#include "engine/simulate/run/lane_runner.hpp"

namespace stepwire::run {

/// Collects runs of one plan from several threads into lanes.
///
/// Fits and tunings make runs one after the other in each of several threads, so no thread has enough runs to
/// fill the lanes. Each thread therefore blocks in run() until its plan has as many runs as there are lanes,
/// or until no other thread can bring a run. One of the waiting threads then steps the whole group.
class LaneBatcher {
 public:
  /// The plans and `interrupt` must outlive it.
  LaneBatcher(std::vector<PlanOfRuns> members, LaneUse use, plan::CodeSource* source,
              const std::atomic<bool>* interrupt)
      : runner_(std::move(members), use, source, interrupt) {}

  /// Returns the number of threads that fill the lanes of `cores` cores (0: all).
  unsigned threads(unsigned cores) const;

  /// Calls task(0) to task(count - 1), which bring runs, on `threads` threads. A thread counts as a source of
  /// runs until its last task ends. Tasks may call this function. Exceptions of tasks are rethrown.
  void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task);

  /// Makes a run from time 0 in lanes and returns true. Returns false, with the run unchanged, if it is to be
  /// made alone, with the code `alone` (nullptr: interpreted). While lanes are not compiled, the caller
  /// reports ticks to done(). Thread-safe for threads of in_parallel().
  bool run(std::size_t member, const plan::CompiledPlan* alone, PendingRun& run);
  void done(std::int64_t ticks) { runner_.done(ticks); }
  LaneReport lanes() const { return runner_.report(); }
  LaneRunner& runner() { return runner_; }
  const LaneRunner& runner() const { return runner_; }

 private:
  class Tasks;
  struct Waiting {
    std::size_t member;
    PendingRun* run;
    bool ended = false, together = false;
    std::exception_ptr failure{};
  };

  std::size_t waiting_for(std::size_t member) const;
  bool may_go(std::size_t member) const;
  std::vector<Waiting*> take(std::size_t member);
  void step(std::size_t member, const plan::CompiledPlan* alone, std::unique_lock<std::mutex>& lock);

  LaneRunner runner_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Waiting*> waiting_;  ///< Runs that have not begun, in order of arrival.
  std::size_t expected_ = 1;       ///< Threads that may bring runs, including the first one.
  std::size_t busy_ = 0;           ///< Threads of them that are stepping their runs.
};

}  // namespace stepwire::run

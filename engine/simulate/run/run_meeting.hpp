#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

#include "engine/simulate/run/together_runs.hpp"

namespace stepwire::run {

/// Where threads bring runs that are to be made, one after the other each, so that those of one plan are
/// stepped together: a thread waits until as many are there as there are lanes, or until no other thread can
/// bring one.
class RunMeeting {
 public:
  /// The plans and what `interrupt` points to must outlive it.
  RunMeeting(TogetherRuns::Members members, LaneUse use, plan::CodeSource* source,
             const std::atomic<bool>* interrupt)
      : together_(std::move(members), use, source, interrupt) {}

  /// So many threads fill the lanes, where there may be some, of so many cores (0: all).
  unsigned threads(unsigned cores) const;

  /// Does task(0) to task(count - 1), which bring runs, on so many threads; each is waited for until it ends
  /// its last one. Tasks may do the same. What a task throws is thrown again.
  void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task);

  /// Makes a run that stands at time 0, and gives true; false, and nothing has happened, where it is to go
  /// alone, by what `alone` points to; null: no code is there. Where lanes are not there yet, done() has to
  /// say how far it went. From any thread that is expected.
  bool run(std::size_t member, const plan::CompiledPlan* alone, PendingRun& run);
  void done(std::int64_t ticks) { together_.done(ticks); }
  LaneReport lanes() const { return together_.report(); }

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
  void go(std::size_t member, const plan::CompiledPlan* alone, std::unique_lock<std::mutex>& lock);

  TogetherRuns together_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Waiting*> waiting_;  ///< that have not begun, in the order in which they came
  std::size_t expected_ = 1;       ///< threads that may bring runs; the first one always may
  std::size_t busy_ = 0;           ///< of them, those whose runs go on
};

}  // namespace stepwire::run

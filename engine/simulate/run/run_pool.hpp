#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "engine/simulate/run/device_runs.hpp"
#include "engine/simulate/run/lane_batcher.hpp"
#include "engine/simulate/run/plan_family.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

class RunPool;

/// Run of a pool: an executor at time 0 with the values of the run. The destructor returns the executor.
class PooledRun {
 public:
  PooledRun(RunPool& pool, std::size_t member, std::unique_ptr<Executor> simulation)
      : pool_(&pool), member_(member), simulation_(std::move(simulation)) {}
  /// Makes a run whose plan no other run uses.
  PooledRun(RunPool& pool, std::shared_ptr<const plan::Plan> plan);
  ~PooledRun();
  PooledRun(PooledRun&&) = default;
  PooledRun& operator=(PooledRun&&) = delete;

  Executor& simulation() const { return *simulation_; }
  /// Returns the member of the family whose plan the run has; PlanFamily::none for a plan of its own.
  std::size_t member() const { return member_; }
  bool has_own_plan() const { return own_ != nullptr; }

 private:
  RunPool* pool_;
  std::shared_ptr<const plan::Plan> own_;  ///< nullptr for a plan of the family
  std::size_t member_ = PlanFamily::none;
  std::unique_ptr<Executor> simulation_;
};

/// Expected work of a pool, by which it decides what to compile.
struct PoolWork {
  double ticks = 0.0;               ///< Ticks of all runs together.
  std::vector<std::size_t> runs{};  ///< Number of runs of each member; empty if unknown.
  bool keeps_rows = true;           ///< False if only the last row of each run is kept.
};

/// Runs on the plans of a family, for sweeps, studies, fits and tunings.
///
/// The pool has the idle executors, the compiled code and the lanes of the plans. A run takes an executor of
/// its plan, or a new one if all are in use, and sets its values. Values that change the structure get a plan
/// that only this run uses, without code and lanes. The results are the same to the last bit in each case.
/// Thread-safe.
class RunPool {
 public:
  /// Members that the family gets later have neither code nor lanes. The family must outlive the pool.
  RunPool(const PlanFamily& family, RunOptions options, const PoolWork& work = {});

  /// Begins a run of a member with these values. Throws Error for refused values.
  PooledRun begin(std::size_t member, const std::vector<diagram::Setting>& values);
  /// Does the same with a new plan.
  PooledRun begin_anew(std::size_t member, const std::vector<diagram::Setting>& values);
  /// Makes the run, the `index`-th of several, in a lane batch with runs of other threads if possible. An
  /// observer of this run alone excludes lanes.
  RunResult run(const PooledRun& run, std::size_t index, RunObserver* observer = nullptr);
  /// Makes runs of one member, in lanes if possible. `values_of` returns the values of a run by its index.
  void run(std::size_t member, const PlanFamily::ValuesOfRun& values_of, std::vector<PendingRun>& runs);

  /// Returns the largest number of runs of a member that are stepped together.
  std::size_t at_once(std::size_t member) const;
  /// Returns the number of threads that fill the lanes of `cores` cores (0: all).
  unsigned threads(unsigned cores) const { return lanes_.threads(cores); }
  /// Calls task(0) to task(count - 1), which make runs, on `threads` threads.
  void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& task) {
    lanes_.in_parallel(count, threads, task);
  }
  /// True if every plan of the family has compiled code.
  bool compiled() const;
  bool interrupted() const { return options_.interrupt && *options_.interrupt; }
  LaneReport lanes() const;

 private:
  friend class PooledRun;

  std::unique_ptr<Executor> take(std::size_t member);
  void give_back(std::size_t member, std::unique_ptr<Executor> simulation);
  /// Makes runs on the processor, at most as many as there are lanes.
  void run_here(std::size_t member, std::span<PendingRun> runs);
  void run_alone(std::size_t member, PendingRun& run, RunObserver* observer = nullptr);

  const PlanFamily& family_;
  const RunOptions options_;
  std::mutex mutex_;
  std::vector<std::vector<std::unique_ptr<Executor>>> idle_;  ///< unused executors of each member
  std::unique_ptr<DeviceRuns> device_;                        ///< nullptr without a device
  TieredExecution code_;
  LaneBatcher lanes_;
};

}  // namespace stepwire::run

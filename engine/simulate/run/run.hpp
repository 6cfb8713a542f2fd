#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/lane_code.hpp"
#include "engine/simulate/run/loop_cost.hpp"
#include "engine/simulate/run/observer.hpp"
#include "engine/simulate/run/plan_family.hpp"
#include "engine/simulate/run/run_numbers.hpp"
#include "engine/simulate/run/tiered_execution.hpp"

namespace stepwire::run {

/// What a call may change about a run.
struct RunOptions {
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, the run ends and keeps what it has
  std::function<void(double)>
      progress;          ///< called with the fraction done, 0 to 1, now and then, from any thread
  unsigned threads = 0;  ///< for sweeps; 0: all cores
  ExecutionMode engine = ExecutionMode::interpreted;
  plan::CodeSource* code = nullptr;     ///< for any other engine
  LaneUse lanes = LaneUse::automatic;   ///< for the runs of a sweep, beside the interpreted engine
  std::vector<RunObserver*> observers;  ///< of every run; must outlive the call
  const RunNumbers* numbers = nullptr;  ///< what is kept of each run of a sweep in place of its rows
};

/// How a run ended, beside what it recorded.
struct RunEnd {
  std::vector<RunFault> faults;  ///< at most one for each run
  std::vector<RaisedDiagnostic> diagnostics;
  std::vector<LoopCost> loops;  ///< algebraic loops that were solved, in all runs together
  StepCount steps;              ///< of a solver that chooses them, in all runs together
  EventCount events;            ///< that were located, in all runs together
  bool interrupted = false;
  bool stopped = false;             ///< by an observer, at least one run
  std::int64_t ticks = 0;           ///< of all runs together
  std::int64_t compiled_ticks = 0;  ///< of them, those that compiled code made
  std::int64_t lane_ticks = 0;      ///< of these, those of runs that were stepped together
};

/// How runs of a sweep were stepped.
struct LaneReport {
  int count = 1;          ///< so many together
  std::string why_not{};  ///< why some or all went one by one: a sentence; or nothing
};

/// What a run, or all runs of a sweep, gave.
struct RunResult : RunEnd {
  std::vector<record::Recording> recordings;  ///< one for each period at which the file records
  LaneReport lanes{};
};

/// Runs a plan once, from 0 to its stop.
RunResult run_plan(const plan::Plan& plan, const RunOptions& options = {});

/// Runs a simulation that stands at time 0, as the run `index` of several ones that share a changeover to
/// compiled code, as its `member`.
RunEnd run_simulation(Executor& simulation, std::vector<record::Recorder>& recorders,
                      const RunOptions& options, TieredExecution& changeover, std::size_t member,
                      std::size_t index);

/// How a run has ended that went with a drive, or in a lane.
RunEnd end_of(const Executor& simulation);

/// Why a run ended that is not healthy.
std::string fault_of(const Executor& simulation);

/// One run of a sweep, or of a study.
struct SweepPoint {
  std::size_t member = 0;               ///< of Job::family, whose plan it runs
  std::vector<diagram::Setting> own{};  ///< what it sets beside the values of its sweep
};

/// A diagram ready to run: one plan, or one for each structure that the points of its sweep have. Everything
/// that can be wrong before the first step has been found.
struct Job {
  plan::Plan plan;                     ///< with the file's own values
  std::vector<SweepPoint> points;      ///< empty without a sweep
  std::shared_ptr<PlanFamily> family;  ///< the plans of the points; null without a sweep
  bool trials = false;                 ///< the points are trials of a study, which set their own values alone

  /// The plan that a point runs once its settings are set.
  const plan::Plan& plan_of(std::size_t point) const { return family->plan(points[point].member); }
  /// What a point sets.
  std::vector<diagram::Setting> settings_of(std::size_t point) const;
};

/// What some or all points of a sweep set beside their own values, in the order of the sweep.
using PointSettings = std::vector<std::vector<diagram::Setting>>;

/// Loads and plans a file and all points of its sweep, these on so many threads (0: all cores). `stop`
/// replaces the file's stop time. Throws Error.
Job make_job(diagram::Loader& loader, const std::string& path,
             const std::vector<diagram::Setting>& settings = {}, std::optional<std::string> stop = {},
             const PointSettings& of_points = {}, unsigned threads = 0);

/// The swept parameters of a point: columns of one row, words as their numbers. None without a sweep.
std::vector<table::Column> swept_columns(const Job& job, std::size_t point);

/// Runs a job; the points of a sweep in parallel, pooled in the order of the sweep: the same bits at any
/// number of threads.
RunResult run_job(const Job& job, const RunOptions& options = {});

}  // namespace stepwire::run

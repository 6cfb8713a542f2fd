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

class DeviceSource;

/// Options of a call that runs a plan or a job.
struct RunOptions {
  const std::atomic<bool>* interrupt = nullptr;  ///< Ends the run once true; its rows stay.
  std::function<void(double)> progress;          ///< Callback with the done fraction, from any thread.
  unsigned threads = 0;                          ///< Threads of a sweep; 0: all cores.
  ExecutionMode engine = ExecutionMode::interpreted;
  plan::CodeSource* code = nullptr;     ///< Source of compiled code, for engines that use it.
  LaneUse lanes = LaneUse::automatic;   ///< Use of lanes in a sweep, with the interpreted engine too.
  DeviceSource* device = nullptr;       ///< Device for the runs of a sweep; nullptr: the processor alone.
  std::vector<RunObserver*> observers;  ///< Observers of every run; must outlive the call.
  bool shows_rows = true;               ///< True if the observers read the recorded rows.
  const RunNumbers* numbers = nullptr;  ///< Numbers that replace the rows of each run of a sweep.
};

/// End of a run: faults, diagnostics and counts, without its recording.
struct RunEnd {
  std::vector<RunFault> faults;  ///< At most one fault for each run.
  std::vector<RaisedDiagnostic> diagnostics;
  std::vector<LoopCost> loops;  ///< Algebraic loops of all runs together.
  StepCount steps;              ///< Steps of solvers with error control, of all runs together.
  EventCount events;            ///< Located events of all runs together.
  bool interrupted = false;
  bool stopped = false;             ///< True if an observer has stopped at least one run.
  std::int64_t ticks = 0;           ///< Ticks of all runs together.
  std::int64_t compiled_ticks = 0;  ///< Ticks of them that compiled code made.
  std::int64_t lane_ticks = 0;      ///< Ticks of these that were made in lanes.
};

/// Report on the runs of a sweep that a device has made.
struct DeviceReport {
  std::string name{};     ///< Name of the device; empty if none was used.
  std::size_t runs = 0;   ///< Runs that it has made.
  std::string why_not{};  ///< Reason why the processor has made runs, a sentence; empty without one.
};

/// Report on how the runs of a sweep were stepped.
struct LaneReport {
  int count = 1;          ///< Number of lanes.
  std::string why_not{};  ///< Reason for single runs, a sentence; empty without one.
  DeviceReport device{};
};

/// Result of a run, or of all runs of a sweep.
struct RunResult : RunEnd {
  std::vector<record::Recording> recordings;  ///< one for each period at which the file records
  LaneReport lanes{};
};

/// Runs a plan once, from 0 to its stop time.
RunResult run_plan(const plan::Plan& plan, const RunOptions& options = {});

/// Runs a simulation from time 0, as the run `index` of several ones that share compiled code, with the plan
/// of `member`.
RunEnd run_simulation(Executor& simulation, std::vector<record::Recorder>& recorders,
                      const RunOptions& options, TieredExecution& changeover, std::size_t member,
                      std::size_t index);

/// Returns the end of a run that a Drive or a lane group has made.
RunEnd end_of(const Executor& simulation);

/// Returns the reason why a run that is not healthy has ended.
std::string fault_of(const Executor& simulation);

/// Run of a sweep, or of a study.
struct SweepPoint {
  std::size_t member = 0;               ///< Member of Job::family whose plan it runs.
  std::vector<diagram::Setting> own{};  ///< Values that it sets beside those of the sweep.
};

/// Diagram that is ready to run: one plan, or one for each structure among the points of its sweep. All
/// faults that exist before the first step have been reported.
struct Job {
  plan::Plan plan;                     ///< Plan with the values of the file.
  std::vector<SweepPoint> points;      ///< Empty without a sweep.
  std::shared_ptr<PlanFamily> family;  ///< Plans of the points; nullptr without a sweep.
  bool trials = false;  ///< True if the points are trials of a study, which set only their own values.

  /// Returns the plan that a point runs once its settings are set.
  const plan::Plan& plan_of(std::size_t point) const { return family->plan(points[point].member); }
  /// Returns the settings of a point.
  std::vector<diagram::Setting> settings_of(std::size_t point) const;
};

/// Additional settings of some or all points of a sweep, in the order of the sweep.
using PointSettings = std::vector<std::vector<diagram::Setting>>;

/// Loads and plans a file and all points of its sweep, the points on `threads` threads (0: all cores). `stop`
/// replaces the file's stop time. Throws Error.
Job make_job(diagram::Loader& loader, const std::string& path,
             const std::vector<diagram::Setting>& settings = {}, std::optional<std::string> stop = {},
             const PointSettings& of_points = {}, unsigned threads = 0);

/// Returns the swept parameters of a point as columns of one row, with words as their numbers. Empty without
/// a sweep.
std::vector<table::Column> swept_columns(const Job& job, std::size_t point);

/// Runs a job. The points of a sweep run in parallel and are pooled in the order of the sweep, with the same
/// bits at any number of threads.
RunResult run_job(const Job& job, const RunOptions& options = {});

}  // namespace stepwire::run

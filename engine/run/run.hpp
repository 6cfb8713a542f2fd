#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/diagram/load.hpp"
#include "engine/record/recording.hpp"
#include "engine/run/changeover.hpp"
#include "engine/run/simulation.hpp"

namespace stepwire {

/// What a call may change about a run.
struct RunOptions {
  const std::atomic<bool>* interrupt = nullptr;  ///< once true, the run ends and keeps what it has
  std::function<void(double)> progress;  ///< told the fraction done, 0 to 1, now and then, from any thread
  unsigned threads = 0;                  ///< for sweeps; 0: all cores
  Engine engine = Engine::interpreted;
  CodeSource* code = nullptr;                    ///< for any other engine
  std::function<void(const Simulation&)> ended;  ///< shown a run as it stands at its end, from any thread
};

/// What a run, or all runs of a sweep, gave.
struct RunResult {
  std::vector<Recording> recordings;  ///< one for each period at which the file records
  std::vector<RunFault> faults;       ///< at most one for each run
  std::vector<RaisedNotice> notices;
  bool interrupted = false;
  std::int64_t ticks = 0;           ///< of all runs together
  std::int64_t compiled_ticks = 0;  ///< of them, those that compiled code made
};

/// Runs a plan once, from 0 to its stop.
RunResult run_plan(const Plan& plan, const RunOptions& options = {});

/// The same as one of several runs, the `index`-th, that share a changeover to compiled code.
RunResult run_plan(const Plan& plan, const RunOptions& options, Changeover& changeover, std::size_t index);

/// One point of a sweep: what it sets, and what columns that adds to the recording.
struct SweepPoint {
  std::vector<Setting> settings;
  Plan plan;
};

/// A diagram ready to run: one plan, or one for each point of its sweep. Everything that can be wrong before
/// the first step has been found.
struct Job {
  Plan plan;                       ///< with the file's own values
  std::vector<SweepPoint> points;  ///< empty without a sweep
};

/// What some or all points of a sweep set beside their own values, in the order of the sweep.
using PointSettings = std::vector<std::vector<Setting>>;

/// Loads and plans a file and all points of its sweep. `stop` replaces the file's stop time. Throws Error.
Job make_job(Loader& loader, const std::string& path, const std::vector<Setting>& settings = {},
             std::optional<std::string> stop = {}, const PointSettings& of_points = {});

/// The swept parameters of a point: columns of one row, words as their numbers. None without a sweep.
std::vector<Column> swept_columns(const Job& job, std::size_t point);

/// Runs a job; the points of a sweep in parallel, pooled in the order of the sweep: the same bits at any
/// number of threads.
RunResult run_job(const Job& job, const RunOptions& options = {});

}  // namespace stepwire

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/kept_rows.hpp"
#include "engine/simulate/run/memory.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

namespace {

/// " (in the run with speed=3)".
std::string which_run(const std::vector<diagram::Setting>& settings) {
  return fmt::format(" (in the run with {})", settings_text(settings));
}

/// Gathers how the runs of a sweep ended, in their order.
class Ends {
 public:
  explicit Ends(const Job& job) : job_(job) {}

  void add(std::size_t point, RunEnd end) {
    const std::lock_guard lock(mutex_);
    for (RunFault& fault : end.faults) {
      fault.fault.message += which_run(job_.settings_of(point));
      faults_.emplace(point, std::move(fault));
    }
    std::size_t order = 0;
    for (RaisedDiagnostic& diagnostic : end.diagnostics) {
      const std::pair place{point, order++};
      const auto [known, is_new] =
          diagnostics_.try_emplace({diagnostic.block, diagnostic.text}, place, diagnostic);
      if (!is_new && place < known->second.first) known->second = {place, std::move(diagnostic)};
    }
    all_.interrupted = all_.interrupted || end.interrupted;
    all_.stopped = all_.stopped || end.stopped;
    all_.ticks += end.ticks;
    all_.compiled_ticks += end.compiled_ticks;
    add_loops(all_.loops, end.loops);
    all_.events += end.events;
  }

  RunEnd take() {
    for (auto& [point, fault] : faults_) all_.faults.push_back(std::move(fault));
    std::vector<std::pair<Place, RaisedDiagnostic>> diagnostics;
    for (auto& [key, diagnostic] : diagnostics_) diagnostics.push_back(std::move(diagnostic));
    std::ranges::stable_sort(diagnostics, {}, [](const auto& diagnostic) { return diagnostic.first; });
    for (auto& [point, diagnostic] : diagnostics) all_.diagnostics.push_back(std::move(diagnostic));
    return std::move(all_);
  }

 private:
  using Place = std::pair<std::size_t, std::size_t>;  ///< point, and which of its diagnostics

  const Job& job_;
  std::mutex mutex_;
  RunEnd all_;
  std::map<std::size_t, RunFault> faults_;
  std::map<std::pair<std::string, std::string>, std::pair<Place, RaisedDiagnostic>> diagnostics_;
};

/// All points of a job.
class SweepRun {
 public:
  SweepRun(const Job& job, const RunOptions& options)
      : job_(job),
        options_(options),
        swept_(job),
        ends_(job),
        idle_(*job.family),
        changeover_(options.engine, options.code, members_of(job), ticks_of(job)) {
    if (options.numbers || job.plan.diagram.sweep->keep == diagram::Sweep::Keep::final)
      kept_.emplace(job, swept_, options.numbers);
    else
      recording_.emplace(job, swept_, options.threads);
  }

  RunResult run() {
    parallel::in_parallel(job_.points.size(), options_.threads,
                          [this](std::size_t point) { run_point(point); });
    return {ends_.take(), kept_ ? kept_->recordings() : recording_->take()};
  }

 private:
  static std::vector<TieredExecution::Member> members_of(const Job& job) {
    std::vector<TieredExecution::Member> members;
    for (std::size_t m = 0; m < job.family->size(); ++m)
      members.push_back({&job.family->plan(m), job.family->variable(m)});
    return members;
  }

  static double ticks_of(const Job& job) {
    double ticks = 0.0;
    for (std::size_t point = 0; point < job.points.size(); ++point)
      ticks += static_cast<double>(job.plan_of(point).steps);
    return ticks;
  }

  void run_point(std::size_t point) {
    if (options_.interrupt && *options_.interrupt) {  // nothing is kept of what has not begun
      RunEnd end;
      end.interrupted = true;
      return ends_.add(point, std::move(end));
    }
    const std::size_t member = job_.points[point].member;
    auto run = idle_.take(member);
    job_.family->begin(member, job_.settings_of(point), *run);
    if (kept_)
      run_for_row(point, *run);
    else
      run_for_rows(point, *run);
    idle_.give_back(member, std::move(run));
    const double done = static_cast<double>(++done_);
    if (options_.progress) options_.progress(done / static_cast<double>(job_.points.size()));
  }

  void run_for_rows(std::size_t point, Executor& run) {
    std::vector<record::Recorder> recorders = recording_->recorders(point);
    ends_.add(point, end_of(point, run, recorders));
    recording_->done(point, recorders);
  }

  /// One row is kept of the run.
  void run_for_row(std::size_t point, Executor& run) {
    auto recorded = kept_->take(job_.points[point].member);
    RunEnd end = end_of(point, run, recorded->recorders());
    const bool whole = end.faults.empty(), finished = !end.interrupted;
    ends_.add(point, std::move(end));
    if (finished) kept_->done(point, whole, std::move(recorded));
  }

  RunEnd end_of(std::size_t point, Executor& run, std::vector<record::Recorder>& recorders) {
    RunOptions own;
    own.interrupt = options_.interrupt;
    own.observers = options_.observers;
    return run_simulation(run, recorders, own, changeover_, job_.points[point].member, point);
  }

  const Job& job_;
  const RunOptions& options_;
  SweptColumns swept_;
  std::optional<PooledRecording> recording_;  ///< where all rows are kept
  std::optional<KeptRows> kept_;              ///< where one row of each run is
  Ends ends_;
  IdleRuns idle_;
  TieredExecution changeover_;
  std::atomic<std::size_t> done_ = 0;
};

/// What is set from outside is not swept any more: each run has that value.
void pin(diagram::Sweep& sweep, const std::vector<diagram::Setting>& settings) {
  for (diagram::Sweep::Axis& axis : sweep.axes)
    for (const diagram::Setting& setting : settings) {
      if (setting.name != axis.parameter) continue;
      const std::size_t count = sweep.together || axis.sampled ? axis.count() : 1;
      axis.values =
          diagram::SweptValues({setting.value}, {setting.mark}, std::vector<std::uint32_t>(count, 0));
    }
}

std::size_t member_for(PlanFamily& family, const std::vector<diagram::Setting>& settings) {
  try {
    return family.find(settings);
  } catch (const yaml::Error& error) {
    std::vector<yaml::Fault> faults = error.faults();
    for (yaml::Fault& fault : faults) fault.message += which_run(settings);
    throw yaml::Error(std::move(faults));
  }
}

/// A tolerance beside a solver that has none. Where the call or the sweep names the solver, that of the file
/// may be meant for another one.
void refuse_idle_tolerance(const yaml::Document& document, const std::vector<diagram::Setting>& settings,
                           const diagram::Diagram& diagram) {
  if (solve::find_implicit(diagram.solver)) return;
  const auto setting = [&](const std::string& name) {
    return std::ranges::find(settings, name, &diagram::Setting::name);
  };
  const auto refuse = [](const std::string& file, const yaml::Mark& mark) {
    throw yaml::Error(yaml::Fault{{file, mark},
                                  "tolerance",
                                  "only rosenbrock and sdirk have one; take it out, or name one of these",
                                  {}});
  };
  const bool own_parameter = std::ranges::find(diagram.parameters, "tolerance",
                                               &diagram::DiagramParameter::name) != diagram.parameters.end();
  if (const auto set = setting("tolerance"); set != settings.end() && !own_parameter)
    refuse(set->written, set->mark);
  const bool sweeps =
      diagram.sweep && std::ranges::find(diagram.sweep->axes, "solver", &diagram::Sweep::Axis::parameter) !=
                           diagram.sweep->axes.end();
  const yaml::Node* own = document.root.find("tolerance");
  if (own && !sweeps && setting("solver") == settings.end()) refuse(document.file, own->mark);
}

}  // namespace

std::vector<diagram::Setting> Job::settings_of(std::size_t point) const {
  if (trials) return points[point].own;
  std::vector<diagram::Setting> settings;
  const diagram::Diagram& diagram = plan.diagram;
  const auto index = diagram.sweep->indices(point);
  for (std::size_t axis = 0; axis < diagram.sweep->axes.size(); ++axis) {
    const diagram::Sweep::Axis& swept = diagram.sweep->axes[axis];
    if (swept.label) continue;
    settings.push_back({swept.parameter, swept.text(index[axis]), diagram.file, swept.mark(index[axis])});
  }
  settings.insert(settings.end(), points[point].own.begin(), points[point].own.end());
  return settings;
}

Job make_job(diagram::Loader& loader, const std::string& path, const std::vector<diagram::Setting>& settings,
             std::optional<std::string> stop, const PointSettings& of_points) {
  std::vector<diagram::Setting> all = settings;
  if (stop) all.push_back({"stop", *stop, "--stop " + *stop});
  Job job{plan::make_plan(loader.load(path, all)), {}, {}};
  require_solver_memory(job.plan);
  refuse_idle_tolerance(loader.document(path), all, job.plan.diagram);
  static_cast<void>(Executor(job.plan));  // a block's start() may find what no plan shows
  auto& sweep = job.plan.diagram.sweep;
  if (sweep) pin(*sweep, all);
  if (sweep && !sweep->axes.empty())
    job.family = std::make_shared<PlanFamily>(loader, path, std::move(all), job.plan);
  const auto count = sweep ? static_cast<std::size_t>(sweep->count()) : 0;
  for (std::size_t point = 0; point < count; ++point) {
    job.points.push_back({0, point < of_points.size() ? of_points[point] : std::vector<diagram::Setting>{}});
    job.points.back().member = member_for(*job.family, job.settings_of(point));
  }
  require_memory(job);
  return job;
}

std::vector<table::Column> swept_columns(const Job& job, std::size_t point) {
  return SweptColumns(job).of(point);
}

RunResult run_job(const Job& job, const RunOptions& options) {
  return job.points.empty() ? run_plan(job.plan, options) : SweepRun(job, options).run();
}

}  // namespace stepwire::run

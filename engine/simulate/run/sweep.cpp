#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/memory.hpp"
#include "engine/simulate/run/point_queue.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/simulate/run/together_runs.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

namespace {

std::size_t point_count(const diagram::Sweep& sweep) {
  if (sweep.axes.empty()) return 0;
  if (sweep.together) return sweep.axes.front().values.size();
  std::size_t count = 1;
  for (const diagram::Sweep::Axis& axis : sweep.axes) count *= axis.values.size();
  return count;
}

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
    all_.lane_ticks += end.lane_ticks;
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
        recording_(job, swept_, options.threads),
        ends_(job),
        idle_(*job.family),
        changeover_(options.engine, options.code, members_of(job), ticks_of(job)),
        together_(job, options),
        queue_(job) {}

  RunResult run() {
    parallel::in_parallel(job_.points.size(), options_.threads, [this](std::size_t) { run_next(); });
    return {ends_.take(), recording_.take(), together_.lanes(), together_.why_not()};
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

  void run_next() {
    const auto points = queue_.take([this](std::size_t member) { return together_.at_once(member); });
    if (points.empty()) return;
    if (options_.interrupt && *options_.interrupt) return leave_out(points);
    std::vector<SweptRun> runs;
    for (const std::size_t point : points) runs.push_back(begin(point));
    const std::size_t member = job_.points[points.front()].member;
    if (runs.size() == 1 || !together_.run(member, changeover_.code(member), runs))
      for (SweptRun& run : runs) run.end = run_alone(run, member);
    for (SweptRun& run : runs) end(run, member);
  }

  /// Nothing is kept of what has not begun.
  void leave_out(const std::vector<std::size_t>& points) {
    RunEnd end;
    end.interrupted = true;
    for (const std::size_t point : points) ends_.add(point, end);
  }

  SweptRun begin(std::size_t point) {
    const std::size_t member = job_.points[point].member;
    SweptRun run{point, idle_.take(member), recording_.recorders(point), {}};
    job_.family->begin(member, job_.settings_of(point), *run.simulation);
    return run;
  }

  RunEnd run_alone(SweptRun& run, std::size_t member) {
    RunOptions own;
    own.interrupt = options_.interrupt;
    own.observers = options_.observers;
    RunEnd end = run_simulation(*run.simulation, run.recorders, own, changeover_, member, run.point);
    together_.done(end.ticks);
    return end;
  }

  void end(SweptRun& run, std::size_t member) {
    ends_.add(run.point, std::move(run.end));
    recording_.done(run.point, run.recorders);
    idle_.give_back(member, std::move(run.simulation));
    const double done = static_cast<double>(++done_);
    if (options_.progress) options_.progress(done / static_cast<double>(job_.points.size()));
  }

  const Job& job_;
  const RunOptions& options_;
  SweptColumns swept_;
  PooledRecording recording_;
  Ends ends_;
  IdleRuns idle_;
  TieredExecution changeover_;
  TogetherRuns together_;
  PointQueue queue_;
  std::atomic<std::size_t> done_ = 0;
};

/// What is set from outside is not swept any more: each run has that value.
void pin(diagram::Sweep& sweep, const std::vector<diagram::Setting>& settings) {
  for (diagram::Sweep::Axis& axis : sweep.axes)
    for (const diagram::Setting& setting : settings) {
      if (setting.name != axis.parameter) continue;
      const std::size_t count = sweep.together ? axis.values.size() : 1;
      axis.values.assign(count, setting.value);
      axis.marks.assign(count, setting.mark);
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
  const auto index = indices_of(*diagram.sweep, point);
  for (std::size_t axis = 0; axis < diagram.sweep->axes.size(); ++axis) {
    const diagram::Sweep::Axis& swept = diagram.sweep->axes[axis];
    if (swept.label) continue;
    settings.push_back({swept.parameter, swept.values[index[axis]], diagram.file, swept.marks[index[axis]]});
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
  for (std::size_t point = 0; sweep && point < point_count(*sweep); ++point) {
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

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "engine/run/memory.hpp"
#include "engine/run/parallel.hpp"
#include "engine/run/pooling.hpp"
#include "engine/run/run.hpp"

namespace stepwire {

namespace {

std::size_t point_count(const Sweep& sweep) {
  if (sweep.axes.empty()) return 0;
  if (sweep.together) return sweep.axes.front().values.size();
  std::size_t count = 1;
  for (const Sweep::Axis& axis : sweep.axes) count *= axis.values.size();
  return count;
}

/// " (in the run with speed=3)".
std::string which_run(const SweepPoint& point) {
  return fmt::format(" (in the run with {})", settings_text(point.settings));
}

/// Hands out the points to threads one by one; a result stands at its point's place, whoever made it.
class Pool {
 public:
  Pool(const Job& job, const RunOptions& options)
      : job_(job),
        options_(options),
        results_(job.points.size()),
        changeover_(options.engine, options.code, plans_of(job)) {}

  std::vector<RunResult> run() {
    const std::size_t wanted =
        options_.threads ? options_.threads : std::max(1u, std::thread::hardware_concurrency());
    {
      const auto others = begin_threads(std::min(wanted, job_.points.size()), [this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
    return std::move(results_);
  }

 private:
  void work() {
    RunOptions own;
    own.interrupt = options_.interrupt;
    for (std::size_t point = next_++; point < job_.points.size(); point = next_++) {
      try {
        results_[point].interrupted =
            own.interrupt && *own.interrupt;  // nothing is kept of what has not begun
        if (!results_[point].interrupted)
          results_[point] = run_plan(job_.points[point].plan, own, changeover_, point);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
      }
      const std::lock_guard lock(mutex_);
      if (options_.progress)
        options_.progress(static_cast<double>(++done_) / static_cast<double>(job_.points.size()));
    }
  }

  static std::vector<const Plan*> plans_of(const Job& job) {
    std::vector<const Plan*> plans;
    for (const SweepPoint& point : job.points) plans.push_back(&point.plan);
    return plans;
  }

  const Job& job_;
  const RunOptions& options_;
  std::vector<RunResult> results_;
  Changeover changeover_;
  std::atomic<std::size_t> next_ = 0;
  std::size_t done_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

RunResult pool(const Job& job, std::vector<RunResult> results) {
  const SweptColumns swept(job);
  RunResult all;
  all.recordings.resize(job.plan.diagram.records.size());
  for (std::size_t point = 0; point < results.size(); ++point) {
    RunResult& one = results[point];
    for (std::size_t r = 0; r < one.recordings.size(); ++r) {
      swept.add(one.recordings[r], point);
      append_runs(all.recordings[r], std::move(one.recordings[r]));
    }
    for (RunFault& fault : one.faults) {
      fault.fault.message += which_run(job.points[point]);
      all.faults.push_back(std::move(fault));
    }
    for (RaisedNotice& notice : one.notices) {
      const bool told = std::any_of(all.notices.begin(), all.notices.end(), [&](const RaisedNotice& n) {
        return n.block == notice.block && n.text == notice.text;
      });
      if (!told) all.notices.push_back(std::move(notice));
    }
    all.interrupted = all.interrupted || one.interrupted;
    all.ticks += one.ticks;
    all.compiled_ticks += one.compiled_ticks;
  }
  return all;
}

/// What is set from outside is not swept any more: each run has that value.
void pin(Sweep& sweep, const std::vector<Setting>& settings) {
  for (Sweep::Axis& axis : sweep.axes)
    for (const Setting& setting : settings) {
      if (setting.name != axis.parameter) continue;
      const std::size_t count = sweep.together ? axis.values.size() : 1;
      axis.values.assign(count, setting.value);
      axis.marks.assign(count, setting.mark);
    }
}

std::vector<Setting> settings_of(const Sweep& sweep, std::size_t point, const std::string& file) {
  std::vector<Setting> settings;
  const auto index = indices_of(sweep, point);
  for (std::size_t axis = 0; axis < sweep.axes.size(); ++axis) {
    const Sweep::Axis& swept = sweep.axes[axis];
    settings.push_back({swept.parameter, swept.values[index[axis]], file, swept.marks[index[axis]]});
  }
  return settings;
}

Plan plan_point(Loader& loader, const std::string& path, std::vector<Setting> settings,
                const SweepPoint& point) {
  settings.insert(settings.end(), point.settings.begin(), point.settings.end());
  try {
    return make_plan(loader.load_point(path, settings));
  } catch (const Error& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) fault.message += which_run(point);
    throw Error(std::move(faults));
  }
}

}  // namespace

Job make_job(Loader& loader, const std::string& path, const std::vector<Setting>& settings,
             std::optional<std::string> stop, const PointSettings& of_points) {
  std::vector<Setting> all = settings;
  if (stop) all.push_back({"stop", *stop, "--stop " + *stop});
  Job job{make_plan(loader.load(path, all)), {}};
  require_solver_memory(job.plan);
  static_cast<void>(Simulation(job.plan));  // a block's start() may find what no plan shows
  auto& sweep = job.plan.diagram.sweep;
  if (sweep) pin(*sweep, all);
  for (std::size_t point = 0; sweep && point < point_count(*sweep); ++point) {
    SweepPoint made{settings_of(*sweep, point, job.plan.diagram.file), {}};
    if (point < of_points.size())
      made.settings.insert(made.settings.end(), of_points[point].begin(), of_points[point].end());
    made.plan = plan_point(loader, path, all, made);
    job.points.push_back(std::move(made));
  }
  require_memory(job);
  return job;
}

std::vector<Column> swept_columns(const Job& job, std::size_t point) {
  return SweptColumns(job).of(point);
}

RunResult run_job(const Job& job, const RunOptions& options) {
  if (job.points.empty()) return run_plan(job.plan, options);
  return pool(job, Pool(job, options).run());
}

}  // namespace stepwire

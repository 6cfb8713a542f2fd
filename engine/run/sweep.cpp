#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "engine/record/recorder.hpp"
#include "engine/run/memory.hpp"
#include "engine/run/run.hpp"

namespace stepwire {

namespace {

/// Which value each axis takes at a point: the last axis runs fastest.
std::vector<std::size_t> indices(const Sweep& sweep, std::size_t point) {
  std::vector<std::size_t> result(sweep.axes.size(), point);
  if (sweep.together) return result;
  for (std::size_t axis = sweep.axes.size(); axis-- > 0;) {
    result[axis] = point % sweep.axes[axis].values.size();
    point /= sweep.axes[axis].values.size();
  }
  return result;
}

std::size_t point_count(const Sweep& sweep) {
  if (sweep.axes.empty()) return 0;
  if (sweep.together) return sweep.axes.front().values.size();
  std::size_t count = 1;
  for (const Sweep::Axis& axis : sweep.axes) count *= axis.values.size();
  return count;
}

/// The swept parameter as it stands in a point's diagram, if it is one.
const DiagramParameter* swept_parameter(const Diagram& diagram, const std::string& name) {
  const auto found = std::find_if(diagram.parameters.begin(), diagram.parameters.end(),
                                  [&](const DiagramParameter& parameter) { return parameter.name == name; });
  return found == diagram.parameters.end() ? nullptr : &*found;
}

/// A swept value as a number: of a parameter as it was evaluated, of a block's key as it was written.
std::optional<Quantity> swept_number(const Sweep::Axis& axis, std::size_t index, const Diagram& diagram) {
  const DiagramParameter* parameter = swept_parameter(diagram, axis.parameter);
  if (!parameter) return parse_quantity(axis.values[index]);
  const double* number = std::get_if<double>(&parameter->value.content);
  return number ? std::optional(Quantity{*number, parameter->dimension}) : std::nullopt;
}

/// " (in the run with speed=3)".
std::string which_run(const SweepPoint& point) {
  std::string text;
  for (const Setting& setting : point.settings)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", setting.name, setting.value);
  return fmt::format(" (in the run with {})", text);
}

/// Which axes have numbers only; where one value is a word, all values of the axis are.
std::vector<bool> numeric_axes(const Job& job, const Sweep& sweep) {
  std::vector<bool> numeric(sweep.axes.size(), true);
  for (std::size_t point = 0; point < job.points.size(); ++point) {
    const auto index = indices(sweep, point);
    for (std::size_t axis = 0; axis < sweep.axes.size(); ++axis)
      if (!swept_number(sweep.axes[axis], index[axis], job.points[point].plan.diagram)) numeric[axis] = false;
  }
  return numeric;
}

Column swept_column(const Sweep::Axis& axis, std::size_t index, const Diagram& diagram, bool numeric) {
  const auto number = numeric ? swept_number(axis, index, diagram) : std::nullopt;
  Column column{axis.parameter, "", {number ? number->value : static_cast<double>(index)}};
  if (number && number->dimension) column.unit = si_name(*number->dimension);
  return column;
}

/// Adds the swept parameters of one point to its recording, behind the time.
void add_swept(Recording& recording, const Sweep& sweep, const SweepPoint& point,
               const std::vector<std::size_t>& index, const std::vector<bool>& numeric) {
  for (std::size_t axis = 0; axis < sweep.axes.size(); ++axis) {
    Column column = swept_column(sweep.axes[axis], index[axis], point.plan.diagram, numeric[axis]);
    column.values.assign(recording.table.rows(), column.values.front());
    recording.table.columns.insert(recording.table.columns.begin() + 1 + static_cast<std::ptrdiff_t>(axis),
                                   std::move(column));
    if (!numeric[axis]) recording.words.push_back({sweep.axes[axis].parameter, sweep.axes[axis].values});
  }
}

void append(Recording& all, Recording&& one) {
  if (all.table.columns.empty()) {
    all = std::move(one);
    all.starts = {0};
    return;
  }
  all.starts.push_back(all.table.rows());
  for (std::size_t i = 0; i < all.table.columns.size(); ++i) {
    auto& values = all.table.columns[i].values;
    values.insert(values.end(), one.table.columns[i].values.begin(), one.table.columns[i].values.end());
  }
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
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min(wanted, job_.points.size()); ++i)
      threads.emplace_back([this] { work(); });
    threads.clear();
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
  const Sweep& sweep = *job.plan.diagram.sweep;
  const std::vector<bool> numeric = numeric_axes(job, sweep);
  RunResult all;
  all.recordings.resize(job.plan.diagram.records.size());
  for (std::size_t point = 0; point < results.size(); ++point) {
    RunResult& one = results[point];
    for (std::size_t r = 0; r < one.recordings.size(); ++r) {
      add_swept(one.recordings[r], sweep, job.points[point], indices(sweep, point), numeric);
      append(all.recordings[r], std::move(one.recordings[r]));
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
  const auto index = indices(sweep, point);
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
  std::vector<Column> columns;
  if (job.points.empty()) return columns;
  const Sweep& sweep = *job.plan.diagram.sweep;
  const std::vector<bool> numeric = numeric_axes(job, sweep);
  const std::vector<std::size_t> index = indices(sweep, point);
  for (std::size_t axis = 0; axis < sweep.axes.size(); ++axis)
    columns.push_back(
        swept_column(sweep.axes[axis], index[axis], job.points[point].plan.diagram, numeric[axis]));
  return columns;
}

RunResult run_job(const Job& job, const RunOptions& options) {
  if (job.points.empty()) return run_plan(job.plan, options);
  return pool(job, Pool(job, options).run());
}

}  // namespace stepwire

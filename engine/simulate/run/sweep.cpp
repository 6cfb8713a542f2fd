#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/simulate/run/memory.hpp"
#include "engine/simulate/run/point_exchange.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

namespace {

/// Replaces the values of a swept parameter by the value of a setting, for all runs.
void pin(diagram::Sweep& sweep, const std::vector<diagram::Setting>& settings) {
  for (diagram::Sweep::Axis& axis : sweep.axes)
    for (const diagram::Setting& setting : settings) {
      if (setting.name != axis.parameter) continue;
      const bool paired = sweep.together || axis.group != diagram::Sweep::Group::none;
      const std::size_t count = paired ? axis.count() : 1;
      axis.values =
          diagram::SweptValues({setting.value}, {setting.mark}, std::vector<std::uint32_t>(count, 0));
    }
}

/// Adds the points of the sweep, with the settings of each beside the values of the sweep.
void add_points(Job& job, const PointSettings& of_points, unsigned threads) {
  job.points.resize(static_cast<std::size_t>(job.plan.diagram.sweep->count()));
  for (std::size_t point = 0; point < std::min(job.points.size(), of_points.size()); ++point)
    job.points[point].own = of_points[point];
  if (job.points.empty()) return;
  const auto members = job.family->find_all(
      job.points.size(), [&](std::size_t point) { return job.settings_of(point); }, threads);
  for (std::size_t point = 0; point < members.size(); ++point) job.points[point].member = members[point];
}

/// Throws Error for a tolerance of a solver that has none. If the call or the sweep names the solver, the
/// tolerance of the file may be meant for another one and is accepted.
void refuse_idle_tolerance(const yaml::Document& document, const std::vector<diagram::Setting>& settings,
                           const diagram::Diagram& diagram) {
  if (!diagram.error_control && solve::find_called(diagram.solver, false)) return;
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
             std::optional<std::string> stop, const PointSettings& of_points, unsigned threads) {
  std::vector<diagram::Setting> all = settings;
  if (stop) all.push_back({"stop", *stop, "--stop " + *stop});
  Job job{plan::make_plan(loader.load(path, all)), {}, {}};
  require_solver_memory(job.plan);
  refuse_idle_tolerance(loader.document(path), all, job.plan.diagram);
  static_cast<void>(Executor(job.plan));  // start() of a block may find faults that planning does not
  auto& sweep = job.plan.diagram.sweep;
  if (sweep) pin(*sweep, all);
  if (sweep && !sweep->axes.empty())
    job.family = std::make_shared<PlanFamily>(loader, path, std::move(all), job.plan);
  if (job.family) add_points(job, of_points, threads);
  require_memory(job);
  return job;
}

std::vector<table::Column> swept_columns(const Job& job, std::size_t point) {
  return SweptColumns(job).of(point);
}

RunResult run_job(const Job& job, const RunOptions& options) {
  if (job.points.empty()) return run_plan(job.plan, options);
  if (!keeps_a_row(job, options.numbers)) require_memory_of_all_rows(job);
  JoinedPoints points(job, options);
  const LaneReport lanes = run_points(job, options, points);
  RunResult result = points.result();
  result.lanes = lanes;
  return result;
}

}  // namespace stepwire::run

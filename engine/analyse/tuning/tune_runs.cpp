#include "engine/analyse/tuning/tune_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/linear/columns.hpp"
#include "engine/simulate/run/drive.hpp"

namespace stepwire::tuning {

namespace {

/// Returns all columns that the request reads.
std::vector<std::string> columns_of(const TuneRequest& request) {
  std::vector<std::string> all;
  if (request.targets.empty()) all = request.minimise.columns();
  for (const claim::Claim* claim : request.claims()) {
    for (const query::Formula& value : claim->values)
      all.insert(all.end(), value.columns.begin(), value.columns.end());
    if (claim->where) all.insert(all.end(), claim->where->columns.begin(), claim->where->columns.end());
  }
  return all;
}

bool reads_recording(const TuneRequest& request, std::size_t recording) {
  const auto in = [&](const claim::Claim& claim) { return claim.recording == recording; };
  return std::ranges::any_of(request.minimise.reductions, in) ||
         std::ranges::any_of(request.claims(), [&](const claim::Claim* claim) { return in(*claim); });
}

}  // namespace

/// A plan and the pool of its idle executors.
struct TuneRuns::Structure {
  Structure(const plan::Plan& of, std::vector<std::string> all)
      : plan(of), names(std::move(all)), varied(plan.diagram, names) {}

  /// True if no value that the runs set changes the structure of the plan.
  bool is_free() const { return !varied.structural(); }

  std::unique_ptr<run::Executor> take() {
    const std::lock_guard lock(mutex);
    if (idle.empty()) return std::make_unique<run::Executor>(plan);
    auto run = std::move(idle.back());
    idle.pop_back();
    return run;
  }
  void give_back(std::unique_ptr<run::Executor> run) {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(run));
  }

  const plan::Plan& plan;
  std::vector<std::string> names;  ///< Names that its runs set.
  diagram::Variation varied;
  std::optional<plan::CompiledPlan> code{};
  std::mutex mutex{};
  std::vector<std::unique_ptr<run::Executor>> idle{};
};

std::vector<diagram::Setting> settings_of(const std::vector<TuneParameter>& parameters,
                                          const Values& values) {
  std::vector<diagram::Setting> settings;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto& dimension = parameters[i].dimension;
    const std::string unit =
        dimension && *dimension != unit::Dimension{} ? " " + unit::si_name(*dimension) : "";
    settings.push_back({parameters[i].name, fmt::format("{}{}", values[i], unit), parameters[i].place.file,
                        parameters[i].place.mark});
  }
  return settings;
}

TuneRuns::TuneRuns(TuneSource source, const run::Job& job, const TuneRequest& request)
    : source_(std::move(source)), job_(job), request_(request), swept_(job) {
  const std::size_t records = job.plan.diagram.records.size();
  for (std::size_t i = 0; i < source_.linear.size(); ++i)
    analysed_.push_back(reads_recording(request, records + i));
  const std::vector<std::string> columns = columns_of(request);
  for (const TuneParameter& parameter : request.parameters)
    recorded_.push_back(std::ranges::find(columns, parameter.name) != columns.end());
  if (!source_.perform) make_structures();
  run::TogetherRuns::Members plans;
  if (source_.code) plans = compile();
  const run::LaneUse use = compiled_ ? run::LaneUse::automatic : run::LaneUse::never;
  meeting_ = std::make_unique<run::RunMeeting>(std::move(plans), use, source_.code, source_.interrupt);
}

/// Makes one structure per plan of the sweep.
void TuneRuns::make_structures() {
  std::vector<std::size_t> members;
  for (std::size_t point = 0; point < count(); ++point) {
    const std::size_t member = job_.points.empty() ? 0 : job_.points[point].member;
    const auto known = std::ranges::find(members, member);
    of_point_.push_back(static_cast<std::size_t>(known - members.begin()));
    if (known != members.end()) continue;
    members.push_back(member);
    const plan::Plan& plan = job_.points.empty() ? job_.plan : job_.plan_of(point);
    structures_.push_back(std::make_unique<Structure>(plan, names_at(point, plan)));
  }
}

/// Returns the names that a run of a plan sets at a point: all tuned parameters, and swept ones that do not
/// change the structure.
std::vector<std::string> TuneRuns::names_at(std::size_t point, const plan::Plan& plan) const {
  std::vector<std::string> names;
  if (!job_.points.empty())
    for (const diagram::Setting& setting : job_.settings_of(point))
      if (!diagram::Variation(plan.diagram, {setting.name}).structural()) names.push_back(setting.name);
  for (const TuneParameter& parameter : request_.parameters) names.push_back(parameter.name);
  return names;
}

TuneRuns::~TuneRuns() = default;

std::size_t TuneRuns::count() const {
  return source_.perform ? 1 : std::max<std::size_t>(1, job_.points.size());
}

std::string TuneRuns::label(std::size_t run) const {
  return job_.points.empty() || source_.perform ? "" : run::settings_text(job_.settings_of(run));
}

TuneRuns::Structure& TuneRuns::structure_of(std::size_t point) const {
  return *structures_[of_point_[point]];
}

/// Compiles one plan per structure. Numbers that differ between the points are variable, like the tuned ones.
/// Returns an empty list if a structure depends on the values.
run::TogetherRuns::Members TuneRuns::compile() {
  run::TogetherRuns::Members plans;
  Values start;
  for (const TuneParameter& parameter : request_.parameters) start.push_back(parameter.start);
  for (std::size_t s = 0; s < structures_.size(); ++s) {
    Structure& of = *structures_[s];
    if (!of.is_free()) return {};
    std::vector<plan::VariableBlock> variable = plan::variable_blocks(of.plan, of.varied);
    run::Executor probe(of.plan);
    for (std::size_t point = 0; point < count(); ++point)
      if (of_point_[point] == s &&
          probe.set(of.varied, assignments(point, start)) == run::Executor::Setting::done)
        probe.widen(variable);
    of.code = source_.code->compile(of.plan, variable, {});
    plans.push_back({&of.plan, {std::move(variable), of.varied.targets()}});
  }
  compiled_ =
      std::ranges::all_of(structures_, [](const auto& structure) { return structure->code.has_value(); });
  return plans;
}

std::vector<diagram::Assignment> TuneRuns::assignments(std::size_t point, const Values& values) const {
  std::vector<diagram::Assignment> all;
  const Structure& of = structure_of(point);
  if (!job_.points.empty())
    for (const diagram::Setting& setting : job_.settings_of(point)) {
      if (std::ranges::find(of.names, setting.name) == of.names.end()) continue;
      all.push_back({setting.name, diagram::value_of_text(setting.value, setting.written), setting.written});
      all.back().value.mark = setting.mark;
    }
  for (std::size_t i = 0; i < request_.parameters.size(); ++i) {
    const TuneParameter& parameter = request_.parameters[i];
    all.push_back(
        {parameter.name, diagram::value_of_number(values[i], parameter.dimension), parameter.place.file});
    all.back().value.mark = parameter.place.mark;
  }
  return all;
}

std::vector<record::Recording> TuneRuns::run(const Values& values, unsigned threads,
                                             std::string& fault) const {
  if (source_.perform) return performed(values, fault);
  std::vector<Recordings> of_points(count());
  std::vector<std::string> faults(count());
  meeting_->in_parallel(count(), threads, [&](std::size_t point) {
    if (!interrupted()) of_points[point] = run_point(point, values, faults[point]);
  });
  Recordings all;
  for (std::size_t point = 0; point < count(); ++point) {
    if (!faults[point].empty() || of_points[point].empty()) {
      fault = faults[point].empty() ? "the run recorded nothing" : faults[point];
      return {};
    }
    all.resize(of_points[point].size());
    for (std::size_t i = 0; i < all.size(); ++i) run::append_runs(all[i], std::move(of_points[point][i]));
  }
  return all;
}

std::vector<record::Recording> TuneRuns::performed(const Values& values, std::string& fault) const {
  Recordings recordings;
  try {
    recordings = source_.perform(settings_of(request_.parameters, values), fault);
  } catch (const yaml::Error& error) {  // refused values count as a failed run
    fault = error.what();
  }
  add_parameters(values, recordings);
  return recordings;
}

std::vector<record::Recording> TuneRuns::run_point(std::size_t point, const Values& values,
                                                   std::string& fault) const {
  Structure& of = structure_of(point);
  std::unique_ptr<run::Executor> run;
  Recordings recordings;
  try {
    if (!of.is_free()) return run_anew(point, values, fault);
    run = of.take();
    if (run->set(of.varied, assignments(point, values)) == run::Executor::Setting::done) {
      if (of.code && !run->compiled()) run->use(*of.code);
      run->reset();
      recordings = take(point, values, *run, fault, meeting_.get());
    } else {
      recordings = run_anew(point, values, fault);
    }
  } catch (const yaml::Error& error) {  // refused values count as a failed run
    fault = error.what();
  }
  if (run) of.give_back(std::move(run));
  return recordings;
}

std::vector<record::Recording> TuneRuns::run_anew(std::size_t point, const Values& values,
                                                  std::string& fault) const {
  std::vector<diagram::Setting> settings = source_.settings;
  if (!job_.points.empty())
    for (diagram::Setting& setting : job_.settings_of(point)) settings.push_back(std::move(setting));
  for (diagram::Setting& setting : settings_of(request_.parameters, values))
    settings.push_back(std::move(setting));
  const plan::Plan plan = [&] {
    const std::lock_guard lock(loading_);
    return plan::make_plan(source_.loader.load_point(source_.file, settings));
  }();
  run::Executor simulation(plan);
  return take(point, values, simulation, fault);
}

void TuneRuns::go_alone(run::PendingRun& run) const {
  run::Drive drive(*run.simulation, *run.recorders);
  drive.interrupt = source_.interrupt;
  drive.shows_rows = false;  // rows are read at the end
  run.end.interrupted = drive.run() == run::Drive::End::interrupted;
}

std::vector<record::Recording> TuneRuns::take(std::size_t point, const Values& values,
                                              run::Executor& simulation, std::string& fault,
                                              run::RunMeeting* meeting) const {
  record::RunRecording recording(simulation.plan());
  run::PendingRun run{point, &simulation, &recording.recorders()};
  const Structure& of = structure_of(point);
  const bool together = meeting && meeting->run(of_point_[point], of.code ? &*of.code : nullptr, run);
  if (!together) go_alone(run);
  if (meeting && !together) meeting->done(simulation.tick());
  if (run.end.interrupted) {
    fault = "interrupted";
    return {};
  }
  if (!simulation.healthy()) {
    fault = run::fault_of(simulation);
    return {};
  }
  Recordings recordings = recording.take();
  if (source_.add_shown) source_.add_shown(recordings);
  add_analyses(simulation, recordings);
  if (!job_.points.empty())
    for (record::Recording& one : recordings) swept_.add(one, point);
  add_parameters(values, recordings);
  return recordings;
}

void TuneRuns::add_analyses(const run::Executor& simulation, Recordings& recordings) const {
  for (std::size_t i = 0; i < analysed_.size(); ++i) {
    record::Recording& one = recordings.emplace_back();
    const linear::NamedAnalysis& named = source_.linear[i];
    if (analysed_[i])
      one = linear::analysis_recording(
          named, linear::analyse(linear::linearize(simulation.diagram(), named.request), named.feedback));
    else
      one.table.columns.push_back({"time", "s", {0.0}});
  }
}

void TuneRuns::add_parameters(const Values& values, Recordings& recordings) const {
  for (record::Recording& one : recordings)
    for (std::size_t i = 0; i < values.size(); ++i)
      if (recorded_[i])
        one.table.columns.push_back(
            {request_.parameters[i].name, "", std::vector<double>(one.table.rows(), values[i])});
}

}  // namespace stepwire::tuning

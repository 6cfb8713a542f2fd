#include "engine/analyse/tuning/tune_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/linear/columns.hpp"

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

Values start_of(const std::vector<TuneParameter>& parameters) {
  Values start;
  for (const TuneParameter& parameter : parameters) start.push_back(parameter.start);
  return start;
}

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
    : source_(std::move(source)),
      job_(job),
      request_(request),
      swept_(job),
      family_(source_.loader, source_.file, source_.settings, job.plan) {
  const std::size_t records = job.plan.diagram.records.size();
  for (std::size_t i = 0; i < source_.linear.size(); ++i)
    analysed_.push_back(reads_recording(request, records + i));
  const std::vector<std::string> columns = columns_of(request);
  for (const TuneParameter& parameter : request.parameters)
    recorded_.push_back(std::ranges::find(columns, parameter.name) != columns.end());
  if (!source_.perform) plan_points();
  make_pool();
}

std::vector<diagram::Setting> TuneRuns::settings_at(std::size_t point, const Values& values) const {
  std::vector<diagram::Setting> settings;
  if (!job_.points.empty()) settings = job_.settings_of(point);
  for (diagram::Setting& setting : settings_of(request_.parameters, values))
    settings.push_back(std::move(setting));
  return settings;
}

/// Adds a member for each plan of the sweep.
void TuneRuns::plan_points() {
  std::vector<std::size_t> known;  // members of the job's family, in the order of those of the own one
  for (std::size_t point = 0; point < count(); ++point) {
    const std::size_t of_job = job_.points.empty() ? 0 : job_.points[point].member;
    const auto found = std::ranges::find(known, of_job);
    members_.push_back(static_cast<std::size_t>(found - known.begin()));
    if (found != known.end()) continue;
    known.push_back(of_job);
    const plan::Plan& plan = job_.points.empty() ? job_.plan : job_.plan_of(point);
    family_.add({job_.family, &plan}, settings_at(point, start_of(request_.parameters)));
  }
  if (source_.code) add_differences();
}

/// Makes the numbers that differ between the points variable in the code, like the tuned ones.
void TuneRuns::add_differences() {
  for (std::size_t point = 0; point < count(); ++point) try {
      family_.add_differences(members_[point], settings_at(point, start_of(request_.parameters)));
    } catch (const yaml::Error&) {  // the run of these values reports the fault
    }
}

void TuneRuns::make_pool() {
  run::RunOptions options;
  options.interrupt = source_.interrupt;
  options.code = source_.code;
  options.shows_rows = false;  // rows are read at the end
  if (source_.code && !is_structural()) options.engine = run::ExecutionMode::compiled;
  pool_ = std::make_unique<run::RunPool>(family_, std::move(options));
}

/// True if a tuned parameter changes the structure of a plan.
bool TuneRuns::is_structural() const {
  std::vector<std::string> names;
  for (const TuneParameter& parameter : request_.parameters) names.push_back(parameter.name);
  for (std::size_t m = 0; m < family_.size(); ++m)
    if (diagram::Variation(family_.plan(m).diagram, names).structural()) return true;
  return false;
}

std::size_t TuneRuns::count() const {
  return source_.perform ? 1 : std::max<std::size_t>(1, job_.points.size());
}

std::string TuneRuns::label(std::size_t run) const {
  return job_.points.empty() || source_.perform ? "" : run::settings_text(job_.settings_of(run));
}

std::vector<record::Recording> TuneRuns::run(const Values& values, unsigned threads,
                                             std::string& fault) const {
  if (source_.perform) return performed(values, fault);
  std::vector<Recordings> of_points(count());
  std::vector<std::string> faults(count());
  pool_->in_parallel(count(), threads, [&](std::size_t point) {
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
  try {
    return take(point, values, fault);
  } catch (const yaml::Error& error) {  // refused values count as a failed run
    fault = error.what();
    return {};
  }
}

std::vector<record::Recording> TuneRuns::take(std::size_t point, const Values& values,
                                              std::string& fault) const {
  const run::PooledRun run = pool_->begin(members_[point], settings_at(point, values));
  run::RunResult result = pool_->run(run, point);
  if (result.interrupted) fault = "interrupted";
  if (!result.interrupted && !run.simulation().healthy()) fault = run::fault_of(run.simulation());
  if (!fault.empty()) return {};
  Recordings recordings = std::move(result.recordings);
  if (source_.add_shown) source_.add_shown(recordings);
  add_analyses(run.simulation(), recordings);
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

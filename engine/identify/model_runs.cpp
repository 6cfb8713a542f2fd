#include "engine/identify/model_runs.hpp"

#include <fmt/format.h>

#include "engine/record/recorder.hpp"
#include "engine/run/stopper.hpp"

namespace stepwire {

namespace {

constexpr std::int64_t ticks_between_looks = 1024;  // at the interrupt flag

/// What a record is called: by the first swept parameter where they go together, else by all.
std::string label_of(const Job& job, std::size_t point) {
  if (job.points.empty()) return "";
  const bool together = job.plan.diagram.sweep->together;
  std::string text;
  for (const Setting& setting : job.points[point].settings) {
    if (!text.empty() && together) break;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", setting.value);
  }
  return text;
}

std::string fault_of(const Simulation& simulation) {
  const auto fault = simulation.fault();
  return fault ? fault->fault.text() : "the run ended early";
}

}  // namespace

std::vector<Setting> settings_of(const std::vector<FitParameter>& parameters, const Values& values) {
  std::vector<Setting> settings;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const auto& dimension = parameters[j].dimension;
    const std::string unit = dimension && *dimension != Dimension{} ? " " + si_name(*dimension) : "";
    settings.push_back({parameters[j].name, fmt::format("{}{}", values[j], unit), parameters[j].place.file,
                        parameters[j].place.mark});
  }
  return settings;
}

ModelRuns::ModelRuns(ModelSource source, const Job& job, const FitRequest& request)
    : source_(std::move(source)), job_(job), request_(request) {
  Values start;
  for (const FitParameter& parameter : request.parameters) start.push_back(parameter.start);
  for (std::size_t record = 0; record < std::max<std::size_t>(1, job.points.size()); ++record) {
    labels_.push_back(label_of(job, record));
    swept_.push_back(swept_columns(job, record));
    at_start_.push_back(plan(record, start));
  }
  const Planner planner = [this](std::size_t record, const Values& values) { return plan(record, values); };
  if (source_.code) codes_ = share_code(at_start_, request.parameters, planner, *source_.code);
}

Plan ModelRuns::plan(std::size_t record, const Values& values) const {
  std::vector<Setting> all = source_.settings;
  if (!job_.points.empty())
    all.insert(all.end(), job_.points[record].settings.begin(), job_.points[record].settings.end());
  for (Setting& setting : settings_of(request_.parameters, values)) all.push_back(std::move(setting));
  const std::lock_guard lock(loading_);
  return make_plan(source_.loader.load_point(source_.file, all));
}

std::vector<Recording> ModelRuns::run(std::size_t record, const Values& values, std::string* fault) const {
  if (codes_.empty()) {
    try {
      return run_anew(record, values, fault);
    } catch (const Error& error) {  // refused: as bad as a run that blows up
      if (fault) *fault = error.what();
      return {};
    }
  }
  const CompiledPlan code = codes_[record].code(values);
  Simulation simulation(at_start_[record]);
  simulation.restore({0, codes_[record].workspace(values)});
  simulation.use(code);
  return this->record(record, simulation, fault);
}

std::vector<Recording> ModelRuns::run_anew(std::size_t record, const Values& values,
                                           std::string* fault) const {
  const Plan own = plan(record, values);
  Simulation simulation(own);
  return this->record(record, simulation, fault);
}

std::string ModelRuns::refusal(std::size_t record, const Values& values) const {
  try {
    plan(record, values);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

std::vector<Recording> ModelRuns::record(std::size_t record, Simulation& simulation,
                                         std::string* fault) const {
  const Plan& plan = simulation.plan();
  std::vector<Recorder> recorders;
  for (const RecordRequest& request : plan.diagram.records) recorders.emplace_back(plan, request);
  Stopper stopper(plan);
  while (true) {
    simulation.evaluate();
    if (!simulation.healthy()) break;
    for (Recorder& recorder : recorders) recorder.record(simulation.tick(), simulation.values());
    if (simulation.finished() || stopper.stops(simulation.values())) break;
    simulation.advance();
    if (!simulation.healthy()) break;
    if (simulation.tick() % ticks_between_looks == 0 && source_.interrupt && *source_.interrupt) {
      if (fault) *fault = "interrupted, so that there is nothing yet to write";
      return {};
    }
  }
  if (!simulation.healthy()) {
    if (fault) *fault = fault_of(simulation);
    return {};
  }
  std::vector<Recording> recordings;
  for (const Recorder& recorder : recorders) {
    recordings.push_back(recorder.take());
    Table& table = recordings.back().table;
    for (Column column : swept_[record]) {
      column.values.assign(table.rows(), column.values.front());
      table.columns.push_back(std::move(column));
    }
  }
  return recordings;
}

}  // namespace stepwire

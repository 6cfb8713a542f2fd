#include "engine/identify/model_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "engine/record/recorder.hpp"
#include "engine/run/stopper.hpp"

namespace stepwire {

namespace {

constexpr std::int64_t ticks_between_looks = 1024;  // at the interrupt flag

/// A swept value to be read: its number with up to five digits, and its unit.
std::string brief(const std::string& value) {
  const char* end = value.data() + value.size();
  double number = 0.0;
  const auto [rest, problem] = std::from_chars(value.data(), end, number);
  return problem == std::errc{} ? fmt::format("{:.5g}{}", number, std::string_view(rest, end)) : value;
}

/// What a record is called: by the first swept parameter where they go together, else by all.
std::string label_of(const Job& job, std::size_t point) {
  if (job.points.empty()) return "";
  const bool together = job.plan.diagram.sweep->together;
  std::string text;
  for (const Setting& setting : job.points[point].settings) {
    if (!text.empty() && together) break;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", brief(setting.value));
  }
  return text;
}

/// All parameters a little away from the start, within their bounds, each by another part of its scale.
Values beside_start(const std::vector<FitParameter>& parameters) {
  Values values;
  for (const FitParameter& parameter : parameters) {
    const double step = 1e-3 * (1.0 + 0.1 * static_cast<double>(values.size() % 7)) * parameter.scale;
    values.push_back(parameter.start + (parameter.start + step <= parameter.upper ? step : -step));
  }
  return values;
}

/// All columns that comparisons name.
std::vector<std::string> columns_of(const FitRequest& request) {
  std::vector<std::string> columns;
  const auto add = [&](const Formula& formula) {
    columns.insert(columns.end(), formula.columns.begin(), formula.columns.end());
  };
  for (const FitComparison& comparison : request.comparisons) {
    add(comparison.model.formula);
    add(comparison.measured);
    for (const auto* formula : {&comparison.weight, &comparison.where})
      if (*formula) add(**formula);
  }
  return columns;
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
  const Values start = start_of(request.parameters);
  for (std::size_t record = 0; record < std::max<std::size_t>(1, job.points.size()); ++record) {
    labels_.push_back(label_of(job, record));
    swept_.push_back(swept_columns(job, record));
    at_start_.push_back(plan(record, start));
  }
  find_part();
  const Planner planner = [this](std::size_t record, const Values& values) {
    return plan_run(record, values);
  };
  if (!source_.code || request.parameters.empty()) return;
  SharedCode code = share_code(at_start_, request.parameters, planner, *source_.code);
  codes_ = std::move(code.records);
  planned_ = std::move(code.planned);
}

/// Plans once with all parameters changed, to see what they move, and runs all records at the start.
void ModelRuns::find_part() {
  try {
    part_ =
        MovedPart::find(at_start_.front(), plan(0, beside_start(request_.parameters)), columns_of(request_));
  } catch (const Error&) {  // these values are refused
  }
  for (std::size_t record = 0; part_ && record < at_start_.size(); ++record)
    if (!play_in(record)) part_.reset();
  if (!part_) return;
  const Values start = start_of(request_.parameters);
  for (std::size_t record = 0; record < at_start_.size(); ++record)
    at_start_[record] = plan_run(record, start);
}

/// Keeps what the part reads and what does not move; false where the run ends early.
bool ModelRuns::play_in(std::size_t record) {
  Simulation simulation(at_start_[record]);
  std::vector<double>& tape = tapes_.emplace_back();
  tape.reserve(part_->width() * static_cast<std::size_t>(simulation.plan().steps + 1));
  still_.push_back(take(record, simulation, nullptr, {}, [&] { part_->append(simulation.values(), tape); }));
  const std::vector<std::string> columns = columns_of(request_);
  for (Recording& recording : still_.back()) {
    auto& all = recording.table.columns;
    const auto idle = [&](const Column& column) {
      const bool wanted = std::find(columns.begin(), columns.end(), column.name) != columns.end();
      return !wanted || part_->gives(column.name);
    };
    all.erase(std::remove_if(all.begin() + 1, all.end(), idle), all.end());
  }
  return !still_.back().empty();
}

Diagram ModelRuns::load(std::size_t record, const Values& values) const {
  std::vector<Setting> all = source_.settings;
  if (!job_.points.empty())
    all.insert(all.end(), job_.points[record].settings.begin(), job_.points[record].settings.end());
  for (Setting& setting : settings_of(request_.parameters, values)) all.push_back(std::move(setting));
  const std::lock_guard lock(loading_);
  return source_.loader.load_point(source_.file, all);
}

Plan ModelRuns::plan_run(std::size_t record, const Values& values) const {
  return part_ ? make_plan(part_->of(load(record, values))) : plan(record, values);
}

std::vector<Recording> ModelRuns::run(std::size_t record, const Values& values, std::string* fault) const {
  try {
    std::optional<Plan> own;  // refused values are as bad as a run that blows up
    if (codes_.empty()) own = plan_run(record, values);
    Simulation simulation(own ? *own : at_start_[record]);
    if (!own) simulation.restore({0, codes_[record].workspace(values)});
    const std::optional<CompiledPlan> code = code_of(record, values, own);
    if (code) simulation.use(*code);
    if (!part_) return take(record, simulation, fault);
    const std::vector<double>& tape = tapes_[record];
    return complete(record, take(record, simulation, fault, [&] { part_->play(tape, simulation); }));
  } catch (const Error& error) {
    if (fault) *fault = error.what();
    return {};
  }
}

std::optional<CompiledPlan> ModelRuns::code_of(std::size_t record, const Values& values,
                                               const std::optional<Plan>& own) const {
  if (!own) return codes_[record].code(values);
  return planned_ ? planned_->with(source_.code->numbers(*own)) : std::nullopt;
}

std::vector<Recording> ModelRuns::complete(std::size_t record, std::vector<Recording> moved) const {
  if (moved.empty()) return {};
  std::vector<Recording> recordings = still_[record];
  for (std::size_t i = 0; i < recordings.size(); ++i)
    for (Column& column : moved[i].table.columns)
      if (part_->gives(column.name)) recordings[i].table.columns.push_back(std::move(column));
  return recordings;
}

std::vector<Recording> ModelRuns::run_anew(std::size_t record, const Values& values,
                                           std::string* fault) const {
  const Plan own = plan(record, values);
  Simulation simulation(own);
  return take(record, simulation, fault);
}

std::string ModelRuns::refusal(std::size_t record, const Values& values) const {
  try {
    plan(record, values);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

std::vector<Recording> ModelRuns::take(std::size_t record, Simulation& simulation, std::string* fault,
                                       const std::function<void()>& before_tick,
                                       const std::function<void()>& after_tick) const {
  const Plan& plan = simulation.plan();
  std::vector<Recorder> recorders;
  for (const RecordRequest& request : plan.diagram.records) recorders.emplace_back(plan, request);
  Stopper stopper(plan);
  while (true) {
    if (before_tick) before_tick();
    simulation.evaluate();
    if (!simulation.healthy()) break;
    if (after_tick) after_tick();
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

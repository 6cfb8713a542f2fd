#include "engine/analyse/estimation/model_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "engine/analyse/estimation/tape.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/stop_condition.hpp"

namespace stepwire::estimation {

namespace {

/// Formats a swept value: its number with up to five digits, and its unit.
std::string brief(const std::string& value) {
  const char* end = value.data() + value.size();
  double number = 0.0;
  const auto [rest, problem] = std::from_chars(value.data(), end, number);
  return problem == std::errc{} ? fmt::format("{:.5g}{}", number, std::string_view(rest, end)) : value;
}

/// Returns the label of a record: its first swept parameter if they vary together, else all.
std::string label_of(const run::Job& job, std::size_t point) {
  if (job.points.empty()) return "";
  const bool together = job.plan.diagram.sweep->together;
  std::string text;
  for (const diagram::Setting& setting : job.settings_of(point)) {
    if (!text.empty() && together) break;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", brief(setting.value));
  }
  return text;
}

/// Returns all columns that comparisons read.
std::vector<std::string> columns_of(const FitRequest& request) {
  std::vector<std::string> columns;
  const auto add = [&](const query::Formula& formula) {
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

/// True if the plans of two records can share code that reads these blocks from a table.
bool are_alike(const std::vector<plan::VariableBlock>& variable, const plan::Plan& one,
               const plan::Plan& other) {
  if (one.blocks.size() != other.blocks.size()) return false;
  return std::ranges::all_of(variable, [&](const plan::VariableBlock& of) {
    const AnyBlock &a = one.diagram.blocks[of.block].block, &b = other.diagram.blocks[of.block].block;
    return &a.type() == &b.type() &&
           plan::MemberItems(a.type(), a.get()).outline() == plan::MemberItems(b.type(), b.get()).outline();
  });
}

}  // namespace

std::vector<diagram::Setting> settings_of(const std::vector<FitParameter>& parameters, const Values& values) {
  std::vector<diagram::Setting> settings;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const auto& dimension = parameters[j].dimension;
    const std::string unit =
        dimension && *dimension != unit::Dimension{} ? " " + unit::si_name(*dimension) : "";
    settings.push_back({parameters[j].name, fmt::format("{}{}", values[j], unit), parameters[j].place.file,
                        parameters[j].place.mark});
  }
  return settings;
}

ModelRuns::ModelRuns(ModelSource source, const run::Job& job, const FitRequest& request)
    : source_(std::move(source)), job_(job), request_(request) {
  for (std::size_t record = 0; record < std::max<std::size_t>(1, job.points.size()); ++record) {
    labels_.push_back(label_of(job, record));
    swept_.push_back(run::swept_columns(job, record));
  }
  find_part();
  make_records();
}

std::vector<std::string> ModelRuns::names() const {
  std::vector<std::string> names;
  for (const FitParameter& parameter : request_.parameters) names.push_back(parameter.name);
  return names;
}

/// Finds the part of the diagram that the parameters affect, and records its inputs in a run of each record.
void ModelRuns::find_part() {
  const Values start = start_of(request_.parameters);
  for (std::size_t record = 0; record < records(); ++record) {
    const plan::Plan whole = plan(record, start);
    if (record == 0)
      part_ =
          SensitiveSubdiagram::find(whole, diagram::Variation(whole.diagram, names()), columns_of(request_));
    if (!part_) return;
    if (!play_in(record, whole)) return part_.reset();
  }
}

/// Records the inputs of the part and the constant columns; false if the run ends early.
bool ModelRuns::play_in(std::size_t record, const plan::Plan& whole) {
  run::Executor simulation(whole);
  std::vector<double>& tape = tapes_.emplace_back();
  tape.reserve(part_->width() * static_cast<std::size_t>(whole.steps + 1));
  TapeWriter writer(*part_, tape);
  still_.push_back(take(record, simulation, nullptr, &writer));
  const std::vector<std::string> columns = columns_of(request_);
  for (record::Recording& recording : still_.back()) {
    auto& all = recording.table.columns;
    const auto idle = [&](const table::Column& column) {
      const bool wanted = std::find(columns.begin(), columns.end(), column.name) != columns.end();
      return !wanted || part_->gives(column.name);
    };
    all.erase(std::remove_if(all.begin() + 1, all.end(), idle), all.end());
  }
  return !still_.back().empty();
}

void ModelRuns::make_records() {
  const Values start = start_of(request_.parameters);
  for (std::size_t r = 0; r < records(); ++r) {
    diagram::Diagram diagram = load(r, start);
    records_.push_back(
        std::make_unique<Record>(plan::make_plan(part_ ? part_->of(diagram) : std::move(diagram)), names()));
  }
  run::TogetherRuns::Members plans;
  if (source_.code) plans = compile_all();
  const bool together = compiled_ && !part_;  // a tape is replayed into a single run
  meeting_ = std::make_unique<run::RunMeeting>(std::move(plans),
                                               together ? run::LaneUse::automatic : run::LaneUse::never,
                                               source_.code, source_.interrupt);
}

diagram::Variation ModelRuns::variation(const Record& record) const {
  std::vector<std::string> all = names();
  if (!job_.points.empty())
    for (const diagram::Sweep::Axis& axis : job_.plan.diagram.sweep->axes)
      if (!axis.label) all.push_back(axis.parameter);
  return diagram::Variation(record.plan.diagram, all);
}

std::vector<plan::VariableBlock> ModelRuns::variable(const Record& record) const {
  return plan::variable_blocks(record.plan, variation(record));
}

/// Compiles the records. Those that differ in numbers only share one text, since swept numbers are variable,
/// too.
run::TogetherRuns::Members ModelRuns::compile_all() {
  const plan::Plan& first = records_.front()->plan;
  std::vector<plan::VariableBlock> shared = variable(*records_.front());
  for (const auto& record : records_)
    if (are_alike(shared, first, record->plan))
      plan::widen(shared, first, [&](std::size_t b) { return record->plan.diagram.blocks[b].block.get(); });
  run::TogetherRuns::Members plans;
  for (const auto& record : records_) {
    auto own = are_alike(shared, first, record->plan) ? shared : variable(*record);
    record->code = source_.code->compile(record->plan, own, {});
    plans.push_back({&record->plan, {std::move(own), variation(*record).targets()}});
  }
  compiled_ = std::ranges::all_of(records_, [](const auto& record) { return record->code.has_value(); });
  return plans;
}

diagram::Diagram ModelRuns::load(std::size_t record, const Values& values) const {
  std::vector<diagram::Setting> all = source_.settings;
  if (!job_.points.empty())
    for (diagram::Setting& setting : job_.settings_of(record)) all.push_back(std::move(setting));
  for (diagram::Setting& setting : settings_of(request_.parameters, values))
    all.push_back(std::move(setting));
  const std::lock_guard lock(loading_);
  return source_.loader.load_point(source_.file, all);
}

std::vector<diagram::Assignment> ModelRuns::assignments(const Values& values) const {
  std::vector<diagram::Assignment> assignments;
  for (std::size_t j = 0; j < request_.parameters.size(); ++j) {
    const FitParameter& parameter = request_.parameters[j];
    assignments.push_back(
        {parameter.name, diagram::value_of_number(values[j], parameter.dimension), parameter.place.file});
    assignments.back().value.mark = parameter.place.mark;
  }
  return assignments;
}

std::unique_ptr<run::Executor> ModelRuns::begin(Record& record, const Values& values) const {
  std::unique_ptr<run::Executor> run;
  {
    const std::lock_guard lock(record.mutex);
    if (!record.idle.empty()) {
      run = std::move(record.idle.back());
      record.idle.pop_back();
    }
  }
  if (!run) run = std::make_unique<run::Executor>(record.plan);
  if (run->set(record.varied, assignments(values)) != run::Executor::Setting::done) return nullptr;
  if (record.code && !run->compiled()) run->use(*record.code);
  run->reset();
  return run;
}

void ModelRuns::give_back(Record& record, std::unique_ptr<run::Executor> run) const {
  const std::lock_guard lock(record.mutex);
  if (run) record.idle.push_back(std::move(run));
}

std::vector<record::Recording> ModelRuns::run(std::size_t record, const Values& values,
                                              std::string* fault) const {
  try {
    Record& of = *records_[record];
    std::unique_ptr<run::Executor> run = begin(of, values);
    if (!run) return run_anew(record, values, fault);
    std::optional<TapePlayer> player;
    if (part_) player.emplace(*part_, tapes_[record]);
    std::vector<record::Recording> taken = take(record, *run, fault, player ? &*player : nullptr);
    give_back(of, std::move(run));
    return part_ ? complete(record, std::move(taken)) : taken;
  } catch (const yaml::Error& error) {  // refused values count as a failed run
    if (fault) *fault = error.what();
    return {};
  }
}

std::vector<record::Recording> ModelRuns::complete(std::size_t record,
                                                   std::vector<record::Recording> moved) const {
  if (moved.empty()) return {};
  std::vector<record::Recording> recordings = still_[record];
  for (std::size_t i = 0; i < recordings.size(); ++i)
    for (table::Column& column : moved[i].table.columns)
      if (part_->gives(column.name)) recordings[i].table.columns.push_back(std::move(column));
  return recordings;
}

std::vector<record::Recording> ModelRuns::run_anew(std::size_t record, const Values& values,
                                                   std::string* fault) const {
  const plan::Plan own = plan(record, values);
  run::Executor simulation(own);
  return take(record, simulation, fault);
}

std::string ModelRuns::refusal(std::size_t record, const Values& values) const {
  try {
    Record& of = *records_[record];
    std::unique_ptr<run::Executor> run = begin(of, values);
    if (!run) plan(record, values);
    give_back(of, std::move(run));
    return "";
  } catch (const yaml::Error& error) {
    return error.what();
  }
}

/// Joins a lane batch with other runs of the record's plan; false if there is none.
bool ModelRuns::meet(run::PendingRun& run) const {
  const bool own = meeting_ && &run.simulation->plan() == &records_[run.index]->plan;
  const auto* code = own && records_[run.index]->code ? &*records_[run.index]->code : nullptr;
  return own && meeting_->run(run.index, code, run);
}

void ModelRuns::go_alone(run::PendingRun& run, run::RunObserver* observer) const {
  run::Drive drive(*run.simulation, *run.recorders);
  drive.interrupt = source_.interrupt;
  if (observer) drive.observers = {&observer, 1};
  drive.shows_rows = false;  // rows are read at the end
  run.end.interrupted = drive.run() == run::Drive::End::interrupted;
  if (meeting_) meeting_->done(run.simulation->tick());
}

std::vector<record::Recording> ModelRuns::take(std::size_t record, run::Executor& simulation,
                                               std::string* fault, run::RunObserver* observer) const {
  record::RunRecording recording(simulation.plan());
  run::PendingRun run{record, &simulation, &recording.recorders()};
  if (!meet(run)) go_alone(run, observer);
  if (run.end.interrupted) {
    if (fault) *fault = "interrupted, so that there is nothing yet to write";
    return {};
  }
  if (!simulation.healthy()) {
    if (fault) *fault = run::fault_of(simulation);
    return {};
  }
  std::vector<record::Recording> recordings = recording.take();
  for (record::Recording& one : recordings)
    for (table::Column column : swept_[record]) {
      column.values.assign(one.table.rows(), column.values.front());
      one.table.columns.push_back(std::move(column));
    }
  return recordings;
}

}  // namespace stepwire::estimation

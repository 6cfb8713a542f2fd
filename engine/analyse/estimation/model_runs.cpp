#include "engine/analyse/estimation/model_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

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

/// Records the signals that a part reads, in a run of the whole diagram.
class TapeWriter : public run::RunObserver {
 public:
  TapeWriter(const SensitiveSubdiagram& part, std::vector<double>& tape) : part_(part), tape_(tape) {}
  void evaluated(const run::ObservedRun& run) override { part_.append(run.simulation.values(), tape_); }

 private:
  const SensitiveSubdiagram& part_;
  std::vector<double>& tape_;
};

/// Replays these signals into a run of the part.
class TapePlayer : public run::RunObserver {
 public:
  TapePlayer(const SensitiveSubdiagram& part, const std::vector<double>& tape) : part_(part), tape_(tape) {}
  run::Flow before_tick(const run::ObservedRun& run) override {
    part_.play(tape_, run.simulation);
    return run::Flow::go_on;
  }

 private:
  const SensitiveSubdiagram& part_;
  const std::vector<double>& tape_;
};

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
  plan_records();
  if (auto of_part = plan_part()) family_ = std::move(of_part);
  make_pool();
}

std::unique_ptr<run::PlanFamily> ModelRuns::new_family() const {
  return std::make_unique<run::PlanFamily>(source_.loader, source_.file, source_.settings, job_.plan);
}

std::vector<diagram::Setting> ModelRuns::settings_at(std::size_t record) const {
  return job_.points.empty() ? std::vector<diagram::Setting>{} : job_.settings_of(record);
}

std::vector<std::string> ModelRuns::names() const {
  std::vector<std::string> names;
  for (const FitParameter& parameter : request_.parameters) names.push_back(parameter.name);
  return names;
}

/// Returns the options of interpreted runs.
run::RunOptions ModelRuns::options() const {
  run::RunOptions options;
  options.interrupt = source_.interrupt;
  options.shows_rows = false;  // rows are read at the end
  return options;
}

void ModelRuns::plan_records() {
  family_ = new_family();
  const auto start = settings_of(request_.parameters, start_of(request_.parameters));
  for (std::size_t record = 0; record < records(); ++record) family_->add(start, settings_at(record));
}

/// Returns the plans of the part that the parameters affect, and records its inputs in a run of each record;
/// nullptr if all blocks have to run.
std::unique_ptr<run::PlanFamily> ModelRuns::plan_part() {
  const plan::Plan& whole = family_->plan(0);
  part_ = SensitiveSubdiagram::find(whole, diagram::Variation(whole.diagram, names()), columns_of(request_));
  if (!part_) return nullptr;
  const auto start = settings_of(request_.parameters, start_of(request_.parameters));
  run::RunPool pool(*family_, options());
  auto plans = new_family();
  for (std::size_t record = 0; record < records(); ++record) {
    if (!record_tape(record, pool)) {
      part_.reset();
      return nullptr;
    }
    plan::Plan plan = plan::make_plan(part_->of(family_->load(record, start)));
    plans->add(std::make_shared<const plan::Plan>(std::move(plan)), start, settings_at(record));
  }
  return plans;
}

/// Records the inputs of the part and the constant columns; false if the run ends early.
bool ModelRuns::record_tape(std::size_t record, run::RunPool& pool) {
  const auto start = settings_of(request_.parameters, start_of(request_.parameters));
  const run::PooledRun run = pool.begin(record, start);
  std::vector<double>& tape = tapes_.emplace_back();
  tape.reserve(part_->width() * static_cast<std::size_t>(run.simulation().plan().steps + 1));
  TapeWriter writer(*part_, tape);
  still_.push_back(take(record, pool, run, nullptr, &writer));
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

/// Makes the pool. Records that differ in numbers only share one text of code.
void ModelRuns::make_pool() {
  std::vector<std::string> swept;
  if (!job_.points.empty())
    for (const diagram::Sweep::Axis& axis : job_.plan.diagram.sweep->axes)
      if (!axis.label) swept.push_back(axis.parameter);
  if (source_.code) family_->share_code(swept);
  run::RunOptions options = this->options();
  options.code = source_.code;
  if (source_.code) options.engine = run::ExecutionMode::compiled;
  if (part_) options.lanes = run::LaneUse::never;  // a tape is replayed into a single run
  pool_ = std::make_unique<run::RunPool>(*family_, std::move(options));
}

std::vector<record::Recording> ModelRuns::run(std::size_t record, const Values& values,
                                              std::string* fault) const {
  try {
    const run::PooledRun run = pool_->begin(record, settings_of(request_.parameters, values));
    if (!part_ || run.has_own_plan()) return take(record, *pool_, run, fault);
    TapePlayer player(*part_, tapes_[record]);
    return complete(record, take(record, *pool_, run, fault, &player));
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
  return take(record, *pool_, pool_->begin_anew(record, settings_of(request_.parameters, values)), fault);
}

std::string ModelRuns::refusal(std::size_t record, const Values& values) const {
  try {
    static_cast<void>(pool_->begin(record, settings_of(request_.parameters, values)));
    return "";
  } catch (const yaml::Error& error) {
    return error.what();
  }
}

std::vector<record::Recording> ModelRuns::take(std::size_t record, run::RunPool& pool,
                                               const run::PooledRun& run, std::string* fault,
                                               run::RunObserver* observer) const {
  run::RunResult result = pool.run(run, record, observer);
  if (result.interrupted) {
    if (fault) *fault = "interrupted, so that there is nothing yet to write";
    return {};
  }
  if (!run.simulation().healthy()) {
    if (fault) *fault = run::fault_of(run.simulation());
    return {};
  }
  for (record::Recording& one : result.recordings)
    for (table::Column column : swept_[record]) {
      column.values.assign(one.table.rows(), column.values.front());
      one.table.columns.push_back(std::move(column));
    }
  return std::move(result.recordings);
}

}  // namespace stepwire::estimation

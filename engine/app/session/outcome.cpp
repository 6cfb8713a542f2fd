#include "engine/app/session/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iterator>
#include <limits>

#include "engine/analyse/query/number.hpp"
#include "engine/app/session/linearizing.hpp"
#include "engine/app/session/sweep_sections.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/view/plot/empty_selection.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {
namespace {

claim::Verdict not_judged(const claim::Claim& claim, const std::string& why) {
  claim::Verdict verdict;
  verdict.kind = claim.kind;
  verdict.that = claim.that;
  verdict.check = claim.check;
  verdict.value = std::numeric_limits<double>::quiet_NaN();
  verdict.shown = "none";
  verdict.disagrees = claim.disagrees;
  verdict.note = why;
  return verdict;
}

/// Returns the number of leading settings in which the points differ, for a sweep whose axes advance
/// together.
std::size_t telling_values(const run::Job& job) {
  std::vector<std::vector<diagram::Setting>> points;
  for (std::size_t point = 0; point < job.points.size(); ++point) points.push_back(job.settings_of(point));
  return run::telling_settings(points);
}

/// Shortens a number with a decimal point to four digits; returns other words unchanged.
std::string short_value(const std::string& value) {
  const std::size_t end = std::min(value.find(' '), value.size());
  double number = 0.0;
  const auto [rest, error] = std::from_chars(value.data(), value.data() + end, number);
  const bool is_number = error == std::errc{} && rest == value.data() + end;
  if (!is_number || value.find('.') >= end) return value;
  return query::short_number(number) + value.substr(end);
}

/// Formats settings for the terminal: the first four, with short numbers. claims.json has all of them in
/// full.
std::string short_text(std::vector<diagram::Setting> settings) {
  constexpr std::size_t most = 4;
  const bool is_long = settings.size() > most;
  if (is_long) settings.resize(most);
  for (diagram::Setting& setting : settings) setting.value = short_value(setting.value);
  return run::settings_text(settings) + (is_long ? ", ..." : "");
}

/// Adds the settings of the worst run to a verdict; with cases, only the settings that all cases share.
void name_run(const LoadedModel& model, claim::Verdict& verdict) {
  const run::Job& job = model.job;
  const auto& sweep = job.plan.diagram.sweep;
  const std::size_t cases = has_cases(model) ? sweep->cases().size() : 1;
  if (!verdict.run || *verdict.run * cases >= job.points.size()) return;
  auto settings = job.settings_of(*verdict.run * cases);
  if (cases > 1)
    std::erase_if(settings, [&](const diagram::Setting& setting) {
      return std::ranges::any_of(sweep->axes, [&](const diagram::Sweep::Axis& axis) {
        return axis.of_cases() && axis.parameter == setting.name;
      });
    });
  if (sweep && sweep->together) settings.resize(telling_values(job));
  verdict.worst = run::settings_text(settings);
  verdict.shown += fmt::format(" ({})", short_text(settings));
}

/// Returns the recordings for figures and claims. With cases, a table by cases replaces the kept rows.
std::vector<record::Recording> shown_of(const LoadedModel& model, const run::RunResult& result) {
  std::vector<record::Recording> shown = result.recordings;
  if (has_cases(model)) shown.front() = by_cases(*model.job.plan.diagram.sweep, *model.kept, shown.front());
  return shown;
}

/// Appends the recordings of linear analyses and of the sensitivity after those of the runs. The latter are
/// empty if their rows were discarded.
void add_analyses(const LoadedModel& model, const sensitivity::RunOutcomes& numbers, Outcome& outcome) {
  if (model.linear.empty() && !model.sensitivity) return;
  outcome.shown.resize(std::max(outcome.shown.size(), recordings_of(model)));
  std::ranges::move(linear_recordings(model, outcome.result.diagnostics), std::back_inserter(outcome.shown));
  if (!model.sensitivity) return;
  outcome.shown.push_back(sensitivity::results(*model.sensitivity, numbers));
  for (const query::NamedTable& table : model.tables)
    if (table.name == sensitivity_table)
      *table.table = sensitivity::results_table(*model.sensitivity, numbers, outcome.shown.back());
}

bool shows_more(const LoadedModel& model) {
  return model.scene || !model.linear.empty() || model.sensitivity || has_cases(model);
}

void show_rows(const LoadedModel& model, Outcome& outcome) {
  if (!shows_more(model)) return;
  outcome.shown = shown_of(model, outcome.result);
  if (has_cases(model) && outcome.early()) return;
  if (model.scene && !outcome.rows_passed) scene::add_scene_states(*model.scene, outcome.shown);
}

run::RunOptions options_of(run::ExecutionMode engine, plan::CodeSource& code, const Monitor& monitor,
                           unsigned threads, run::DeviceSource* device) {
  run::RunOptions options;
  options.engine = engine;
  options.code = &code;
  options.interrupt = monitor.interrupt;
  options.progress = [&](double fraction) { monitor.show(fraction); };
  options.observers = monitor.observers;
  options.threads = threads;
  options.device = device;
  return options;
}

class Seconds {
 public:
  double passed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

void add_shown(const LoadedModel& model, Outcome& outcome) {
  show_rows(model, outcome);
  if (has_cases(model) && outcome.early()) return;
  sensitivity::RunOutcomes numbers;
  if (model.sensitivity) sensitivity::add_outcomes(*model.sensitivity, outcome.recordings(), numbers);
  add_analyses(model, numbers, outcome);
}

RunJudges::RunJudges(const LoadedModel& model) : model_(model), of_runs_(recordings_of(model)) {
  for (const claim::Claim& claim : model.claims) judges_.emplace_back(claim);
}

void RunJudges::add(std::span<const record::Recording> runs) {
  for (std::size_t i = 0; i < judges_.size(); ++i)
    if (model_.claims[i].recording < of_runs_) judges_[i].add(runs);
  if (model_.sensitivity) sensitivity::add_outcomes(*model_.sensitivity, runs, numbers_);
}

void RunJudges::judge(Outcome& outcome) {
  const bool early = outcome.early();
  if (outcome.shown.empty() && (!early || has_cases(model_))) show_rows(model_, outcome);
  if (!early) add_analyses(model_, numbers_, outcome);
  for (std::size_t i = 0; i < judges_.size(); ++i) {
    const claim::Claim& claim = model_.claims[i];
    if (!early && claim.recording >= of_runs_) judges_[i].add(outcome.recordings());
    outcome.verdicts.push_back(early ? not_judged(claim, "the run ended early") : judges_[i].verdict());
    name_run(model_, outcome.verdicts.back());
  }
}

void judge_claims(const LoadedModel& model, Outcome& outcome) {
  RunJudges judges(model);
  if (!outcome.early()) {
    show_rows(model, outcome);
    judges.add(outcome.recordings());
  }
  judges.judge(outcome);
}

void judge_again(const LoadedModel& model, Outcome& outcome) {
  outcome.verdicts.clear();
  outcome.shown.clear();
  judge_claims(model, outcome);
}

Outcome run_model(const LoadedModel& model, const run::RunOptions& options) {
  Outcome outcome;
  const Seconds seconds;
  run::RunOptions own = options;
  own.numbers = model.kept.get();
  outcome.result = run::run_job(model.job, own);
  outcome.seconds = seconds.passed();
  judge_claims(model, outcome);
  return outcome;
}

Outcome run_model(const LoadedModel& model, run::ExecutionMode engine, plan::CodeSource& code,
                  const Monitor& monitor, unsigned threads, run::DeviceSource* device) {
  return run_model(model, options_of(engine, code, monitor, threads, device));
}

PointsReport run_points(const LoadedModel& model, run::ExecutionMode engine, plan::CodeSource& code,
                        const Monitor& monitor, run::PointExchange& exchange, unsigned threads,
                        run::DeviceSource* device) {
  run::RunOptions options = options_of(engine, code, monitor, threads, device);
  options.numbers = model.kept.get();
  const Seconds seconds;
  PointsReport report;
  report.lanes = run::run_points(model.job, options, exchange);
  report.seconds = seconds.passed();
  return report;
}

std::vector<std::string> findings_of(const LoadedModel& model, const Outcome& outcome) {
  if (outcome.early()) return {};
  return plot::empty_selections(model.figures, outcome.recordings());
}

}  // namespace stepwire::session

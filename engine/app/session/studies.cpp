#include "engine/app/session/studies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "engine/analyse/study/comparison_tables.hpp"
#include "engine/analyse/study/side_by_side.hpp"
#include "engine/analyse/study/study_columns.hpp"
#include "engine/analyse/study/study_tables.hpp"
#include "engine/app/session/kept_experiments.hpp"
#include "engine/app/session/recorded_study.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/app/session/study_parts.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/plot_tools.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::session {

namespace {

study::Experiments make_experiments(const Registry& registry, const LoadedModel& model, const StudyCall& call,
                                    const Monitor& monitor) {
  const study::StudyRequest& request = *model.study;
  if (!request.trials.empty()) return {study::score_recorded(request, model.job.plan.diagram)};
  KeptExperiments kept(model, call.kept);
  const std::vector<std::uint64_t> seeds = kept.missing();
  StudyCall own = call;
  if (call.workers) own.engine = run::ExecutionMode::interpreted;  // the workers run the trials
  StudyParts parts(registry, model, own, seeds.size(), monitor);
  study::Experiments experiments = call.workers ? perform_by(*call.workers, parts, model, seeds, kept)
                                                : perform_here(*parts.runs, model, seeds, kept, monitor);
  study::number_plans(experiments, *parts.runs);
  parts.runs.reset();  // Ends the compilation, which could still report a problem.
  monitor.note_interpreted(parts.code.take_problem());
  return experiments;
}

/// Returns a sweep whose axes identify the trials: the axes of the file, then subject and condition.
diagram::Sweep axes_of(const LoadedModel& model) {
  const study::StudyRequest& request = *model.study;
  diagram::Sweep sweep = model.job.plan.diagram.sweep.value_or(diagram::Sweep{});
  sweep.axes.push_back({"subject", diagram::SweptValues(request.subject_names()), {}});
  sweep.axes.push_back({"condition", diagram::SweptValues(request.condition_names()), {}});
  return sweep;
}

/// Returns the number of columns, after the time, with swept values.
std::ptrdiff_t swept_columns_of(const record::Recording& recording) {
  const auto first = std::ranges::find(recording.table.columns, "subject", &table::Column::name);
  return first - recording.table.columns.begin() - 1;
}

/// Appends columns with the order of each subject's trials to the table of errors.
void add_sequence(const LoadedModel& model, const study::Experiments& experiments, table::Table& table) {
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    const auto more = study::sequence_columns(experiments[i], *model.study, model.job.plan.diagram);
    const std::size_t first = table.columns.size() - (i == 0 ? 0 : more.size());
    for (std::size_t c = 0; c < more.size(); ++c) {
      if (i == 0) table.columns.push_back({more[c].name, more[c].unit, {}});
      auto& values = table.columns[first + c].values;
      values.insert(values.end(), more[c].values.begin(), more[c].values.end());
    }
  }
}

/// Returns the trials as CSV, with the values that were carried into them.
std::string trials_text(const LoadedModel& model, const study::Experiment& experiment) {
  std::vector<table::Column> columns =
      study::sequence_columns(experiment, *model.study, model.job.plan.diagram);
  if (columns.size() == 1) columns.clear();  // the order of trials is already in the errors
  return study::trials_csv(experiment.trials, columns);
}

/// Returns the errors of all trials as CSV. For a sweep the swept values precede them, as in the recording of
/// errors.
std::string errors_csv(const LoadedModel& model, const study::Experiments& experiments,
                       const record::Recording& recording) {
  study::PathErrors all = experiments.front().errors;
  for (std::size_t i = 1; i < experiments.size(); ++i)
    all.rows.insert(all.rows.end(), experiments[i].errors.rows.begin(), experiments[i].errors.rows.end());
  table::ColumnWords words;
  table::Table table = study::error_table(all, words);
  if (model.study->trials.empty()) add_sequence(model, experiments, table);
  const auto swept = recording.table.columns.begin() + 1;
  table.columns.insert(table.columns.begin(), swept, swept + swept_columns_of(recording));
  for (const record::Categories& one : recording.categories)
    for (const std::string& text : one.texts)
      if (one.column != "subject" && one.column != "condition")
        words[one.column].push_back(without_quotes(text));
  return table::csv_text(table, words);
}

bool is_probability(const std::string& name) {
  return name.starts_with("p.");
}

/// Adds a histogram with a line at the published value. The number of bins grows with the number of
/// experiments.
void draw_value(const study::Distribution& one, plot::FigureBuilder& figure) {
  const bool p = is_probability(one.name);
  std::vector<double> values = one.values;
  const double bins = std::clamp(std::floor(1.5 * std::sqrt(static_cast<double>(values.size()))), 6.0, 40.0);
  if (p)
    for (double& value : values) value = std::log10(value);
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  plot::Panel panel;
  panel.options<plot::HistogramOptions>().bins = bins;
  if (!std::isnan(one.published)) {
    panel.title = fmt::format("published: {:.3g}", one.published);
    panel.options<plot::HistogramOptions>().lines = {p ? std::log10(one.published) : one.published};
  }
  plot::PlotBuilder& plot = figure.add(panel);
  plot::name_axis(plot.spec.x, p ? "log10 of P, " + one.name.substr(2) : one.name, "1");
  plot::draw_histogram(values, plot);
}

}  // namespace

run::ExecutionMode engine_of(const LoadedModel& model, const StudyCall& call, std::size_t experiments) {
  if (call.engine != run::ExecutionMode::automatic) return call.engine;
  // Cost of an interpreted block per tick [s], and mean duration of a trial as a fraction of `stop`.
  constexpr double per_block = 2e-8, part = 0.25;
  // Durations from which a compilation beside the trials, or before them, is worth its cost [s].
  constexpr double beside = 4.0, ahead = 20.0;
  const plan::Plan& plan = model.job.plan;
  const auto trials =
      static_cast<double>(model.study->subjects.size() * model.study->conditions.size() * experiments);
  const double ticks = static_cast<double>(plan.steps) * part * trials;
  const double cores = std::max(1u, std::thread::hardware_concurrency());
  const double seconds = per_block * static_cast<double>(plan.diagram.blocks.size()) * ticks / cores;
  return seconds > ahead    ? run::ExecutionMode::compiled
         : seconds > beside ? run::ExecutionMode::automatic
                            : run::ExecutionMode::interpreted;
}

study::TrialSource trial_source(diagram::Loader& loader, const LoadedModel& model, run::ExecutionMode engine,
                                plan::CodeSource& code, const Monitor& monitor) {
  study::TrialSource source{loader, model.file,       call_settings(model.options), engine, &code,
                            0,      monitor.interrupt};
  source.observers = monitor.observers;
  return source;
}

std::string study_key(const LoadedModel& model, bool with_seed) {
  const study::StudyRequest& request = *model.study;
  std::string key = fmt::format(
      "{} {} {} {} {} {} {} {} {}", model.hash, request.task, fmt::join(request.subjects, ","),
      with_seed ? fmt::format("{}+{}", request.seed, request.experiments) : "", request.subject_parameter,
      request.seed_parameter, request.position, request.attempts, request.trials);
  for (const study::StudyCondition& condition : request.conditions) {
    key += " " + condition.name;
    for (const diagram::Setting& setting : condition.settings)
      key += fmt::format(",{}={}", setting.name, setting.value);
  }
  // The hash has the first point of a sweep; a setting that is without effect there may change others.
  key += fmt::format(" set ({})", run::settings_text(call_settings(model.options)));
  for (std::size_t point = 0; point < model.job.points.size(); ++point)
    key += fmt::format(" ({})", run::settings_text(model.job.settings_of(point)));
  for (const std::size_t condition : request.first) key += fmt::format(" first {}", condition);
  for (const std::size_t condition : request.practice) key += fmt::format(" practice {}", condition);
  for (const study::CarriedValue& carried : request.carry)
    key += fmt::format(" {}={}", carried.parameter, carried.signal);
  if (request.circle)
    key += fmt::format(" {} {} {} {}", request.circle->of, request.circle->x, request.circle->y,
                       request.circle->radius);
  if (request.way_back)
    for (const diagram::SignalRef& signal : {request.way_back->position, request.way_back->direction})
      key += fmt::format(" {}.{}", signal.block, signal.output);
  return key;
}

Studies::Shared Studies::experiments(const Registry& registry, const LoadedModel& model,
                                     const StudyCall& call, const Monitor& monitor) {
  std::promise<Shared> promise;
  std::shared_future<Shared> future;
  bool is_new = false;
  {
    const std::lock_guard lock(mutex_);
    const auto [known, added] = known_.try_emplace(study_key(model));
    if (added) known->second = promise.get_future().share();
    is_new = added;
    future = known->second;
  }
  if (is_new) try {
      promise.set_value(
          std::make_shared<const study::Experiments>(make_experiments(registry, model, call, monitor)));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  return future.get();
}

Outcome study_outcome(LoadedModel& model, const study::Experiments& experiments) {
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  outcome.result.interrupted = experiments.empty();
  if (!experiments.empty()) {
    if (model.job.points.empty())
      study::fill_study_tables(experiments.front(), *model.study, model.tables);
    else
      study::fill_sweep_tables(experiments, *model.study, model.tables);
    outcome.result.recordings = study::study_recordings(experiments, *model.study, model.job);
    model.job.plan.diagram.sweep = axes_of(model);
    model.job.points.clear();
    model.job.family = experiments.front().family;
    model.job.trials = true;
  }
  for (const study::Experiment& experiment : experiments) {
    outcome.result.ticks += experiment.ticks;
    outcome.result.compiled_ticks += experiment.compiled_ticks;
    outcome.result.lane_ticks += experiment.lane_ticks;
    outcome.result.lanes = experiment.lanes;
    for (const study::TrialRun& run : experiment.runs) model.job.points.push_back(run.point);
  }
  judge_claims(model, outcome);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

static std::string tables_text(const LoadedModel& model) {
  std::string all;
  // The tables "experiments..." compare several experiments.
  for (const query::NamedTable& one : model.tables)
    if (model.study->experiments > 1 || !one.name.starts_with("experiments"))
      all += (all.empty() ? "" : "\n") + text::text(*one.table);
  return all;
}

std::vector<StudyFile> study_texts(const LoadedModel& model, const study::Experiments& experiments,
                                   const Outcome& outcome) {
  std::vector<StudyFile> files;
  for (std::size_t i = 0; i < experiments.size(); ++i)
    files.push_back({io::numbered("trials", i, ".csv"), trials_text(model, experiments[i])});
  const record::Recording& errors = outcome.result.recordings[model.job.plan.diagram.records.size()];
  files.push_back({"errors.csv", errors_csv(model, experiments, errors)});
  files.push_back({"tables.txt", tables_text(model)});
  return files;
}

void write_study(const std::string& folder, const LoadedModel& model, const study::Experiments& experiments,
                 const Outcome& outcome) {
  if (model.study->trials.empty())
    replay::write_replay(folder, model.job);
  else
    write_recorded(folder, model);
  for (const StudyFile& file : study_texts(model, experiments, outcome))
    io::write_file(folder + "/" + file.name, file.text);
  io::write_file(folder + "/study.json", result::json_of(StudyReport{&model, &experiments}).text() + "\n");
  if (model.study->experiments > 1 && experiments.size() == 1)
    render::write_figure(folder, "experiments",
                         repetition_figure(study::outcomes(experiments.front(), *model.study), *model.study),
                         "experiments-figure");
}

plot::FigureSpec repetition_figure(const std::vector<study::ExperimentOutcome>& experiments,
                                   const study::StudyRequest& request) {
  std::vector<study::Distribution> known = study::distributions_of_errors(experiments, request);
  std::ranges::move(study::distributions_of_p(experiments, request), std::back_inserter(known));
  plot::FigureBuilder figure(
      {.title = fmt::format("Task {}: {} experiments with simulated operators, and what is published",
                            request.task, experiments.size()),
       .columns = 2},
      known.size());
  for (const study::Distribution& one : known) draw_value(one, figure);
  return figure.finished();
}

}  // namespace stepwire::session

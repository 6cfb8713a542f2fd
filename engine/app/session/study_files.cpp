// Files of a study in its folder.
#include <fmt/format.h>

#include "engine/analyse/study/comparison_tables.hpp"
#include "engine/analyse/study/distribution.hpp"
#include "engine/analyse/study/side_by_side.hpp"
#include "engine/analyse/study/study_columns.hpp"
#include "engine/analyse/study/study_tables.hpp"
#include "engine/app/session/recorded_study.hpp"
#include "engine/app/session/repetition_figure.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::session {

using json::Json;

namespace {

Json settings_json(const std::vector<diagram::Setting>& settings) {
  Json json = Json::object();
  for (const diagram::Setting& setting : settings) json.set(setting.name, without_quotes(setting.value));
  return json;
}

Json trials_json(const study::Experiment& experiment) {
  Json list = Json::list();
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    const study::PathError& row = experiment.errors.rows[i];
    Json trial = Json::object()
                     .set("subject", row.subject)
                     .set("condition", row.condition)
                     .set("error", row.error)
                     .set("normalised", row.normalised)
                     .set("raw", row.raw)
                     .set("deviation", row.deviation)
                     .set("length", row.length)
                     .set("duration", row.duration)
                     .set("points", row.points);
    if (!experiment.runs.empty()) {
      trial.set("order", experiment.runs[i].order)
          .set("attempts", experiment.runs[i].attempts)
          .set("sets", settings_json(experiment.runs[i].point.own));
    }
    list.push(std::move(trial));
  }
  return list;
}

Json orders_json(const study::Experiment& experiment, const study::StudyRequest& request) {
  Json orders = Json::object();
  for (const std::size_t subject : request.subjects) {
    Json names = Json::list();
    for (const std::size_t condition : study::order_of_conditions(request, experiment.seed, subject))
      names.push(request.conditions[condition].feedback.name);
    orders.set(std::to_string(subject), std::move(names));
  }
  return orders;
}

Json analysis_json(const study::TaskAnalysis& analysis, const study::StudyRequest& request,
                   std::uint64_t seed) {
  Json means = Json::object();
  for (const study::NamedValue& mean : analysis.means) means.set(mean.name, mean.value);
  Json both = Json::list();
  for (const study::SideBySide& one : study::compare(request.published, analysis))
    both.push(study::side_by_side_json(one));
  return Json::object()
      .set("means", std::move(means))
      .set("anova", study::anova_json(analysis.additive))
      .set("anova_with_subject", study::anova_json(analysis.with_subject))
      .set("repeated_measures",
           analysis.repeated ? study::anova_json(*analysis.repeated) : Json(analysis.not_repeated))
      .set("within_subjects",
           analysis.within ? study::comparisons_json(*analysis.within, seed) : Json(analysis.not_within))
      .set("side_by_side", std::move(both));
}

/// Returns the outcomes of each experiment.
Json experiments_json(const study::Experiment& experiment, const study::StudyRequest& request) {
  Json list = Json::list();
  for (const study::ExperimentOutcome& one : study::outcomes(experiment, request)) {
    Json json = Json::object().set("seed", one.seed);
    for (const study::NamedValue& value : one.values) json.set(value.name, value.value);
    list.push(std::move(json));
  }
  return list;
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

/// Adds the results of one experiment.
Json add_experiment(Json json, const study::Experiment& experiment, const study::StudyRequest& request) {
  json.set("rule", experiment.errors.rule)
      .set("remarks", Json::list_of(experiment.remarks))
      .set("trials", trials_json(experiment));
  if (!experiment.runs.empty())
    json.set("seed", experiment.seed).set("orders", orders_json(experiment, request));
  if (!experiment.others.empty()) json.set("experiments", experiments_json(experiment, request));
  if (experiment.analysis)
    json.set("analysis", analysis_json(*experiment.analysis, request, experiment.seed));
  return json;
}

}  // namespace

void write_study(const std::string& folder, const LoadedModel& model, const study::Experiments& experiments,
                 const Outcome& outcome) {
  if (model.study->trials.empty())
    replay::write_replay(folder, model.job);
  else
    write_recorded(folder, model);
  for (std::size_t i = 0; i < experiments.size(); ++i)
    io::write_file(folder + "/" + io::numbered("trials", i, ".csv"), trials_text(model, experiments[i]));
  io::write_file(folder + "/errors.csv", errors_text(model, experiments, outcome));
  io::write_file(folder + "/study.json", study_json(model, experiments).text() + "\n");
  io::write_file(folder + "/tables.txt", tables_text(model));
  if (model.study->experiments > 1 && experiments.size() == 1)
    render::write_figure(folder, "experiments",
                         repetition_figure(study::outcomes(experiments.front(), *model.study), *model.study),
                         "experiments-figure");
}

std::string errors_text(const LoadedModel& model, const study::Experiments& experiments,
                        const Outcome& outcome) {
  return errors_csv(model, experiments, outcome.result.recordings[model.job.plan.diagram.records.size()]);
}

std::string tables_text(const LoadedModel& model) {
  std::string all;
  // The tables "experiments..." compare several experiments.
  for (const query::NamedTable& one : model.tables)
    if (model.study->experiments > 1 || !one.name.starts_with("experiments"))
      all += (all.empty() ? "" : "\n") + text::text(*one.table);
  return all;
}

Json study_json(const LoadedModel& model, const study::Experiments& experiments) {
  const study::StudyRequest& request = *model.study;
  Json json = Json::object()
                  .set("file", model.file)
                  .set("task", request.task)
                  .set("trials_of", request.trials.empty() ? "simulated operators" : request.trials);
  if (experiments.front().sets.empty()) return add_experiment(std::move(json), experiments.front(), request);
  Json points = Json::list();
  for (std::size_t i = 0; i < experiments.size(); ++i)
    points.push(add_experiment(Json::object()
                                   .set("sets", settings_json(experiments[i].sets))
                                   .set("trials_file", io::numbered("trials", i, ".csv")),
                               experiments[i], request));
  return json.set("points", std::move(points));
}

}  // namespace stepwire::session

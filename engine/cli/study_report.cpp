// What a study found, for people and for programs.
#include <fmt/format.h>

#include "engine/cli/studying.hpp"
#include "engine/study/published.hpp"
#include "engine/study/side_by_side.hpp"
#include "engine/study/study_tables.hpp"
#include "engine/table/file.hpp"

namespace stepwire {

namespace {

Json trials_json(const Experiment& experiment) {
  Json list = Json::list();
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    const PathError& row = experiment.errors.rows[i];
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
      Json settings = Json::object();
      for (const Setting& setting : experiment.runs[i].point.settings)
        settings.set(setting.name, setting.value);
      trial.set("attempts", experiment.runs[i].attempts).set("sets", std::move(settings));
    }
    list.push(std::move(trial));
  }
  return list;
}

Json orders_json(const Experiment& experiment, const StudyRequest& request) {
  Json orders = Json::object();
  for (const std::size_t subject : request.subjects) {
    Json names = Json::list();
    for (const std::size_t condition : order_of_conditions(request, experiment.seed, subject))
      names.push(request.conditions[condition].feedback.name);
    orders.set(std::to_string(subject), std::move(names));
  }
  return orders;
}

Json analysis_json(const TaskAnalysis& analysis, const StudyRequest& request) {
  Json means = Json::object();
  for (const NamedValue& mean : analysis.means) means.set(mean.name, mean.value);
  Json both = Json::list();
  for (const SideBySide& one : compare(published_task(request.task), analysis))
    both.push(side_by_side_json(one));
  return Json::object()
      .set("means", std::move(means))
      .set("anova", anova_json(analysis.additive))
      .set("anova_with_subject", anova_json(analysis.with_subject))
      .set("repeated_measures",
           analysis.repeated ? anova_json(*analysis.repeated) : Json(analysis.not_repeated))
      .set("side_by_side", std::move(both));
}

std::string all_tables(const Work& work) {
  std::string all;
  for (const NamedTable& one : work.tables) all += (all.empty() ? "" : "\n") + text(*one.table);
  return all;
}

}  // namespace

void write_study(const std::string& folder, const Work& work, const Experiment& experiment) {
  write_file(folder + "/trials.csv", trials_csv(experiment.trials));
  ColumnWords words;
  const Table errors = error_table(experiment.errors, words);
  write_csv(folder + "/errors.csv", errors, words);
  write_file(folder + "/study.json", study_json(work, experiment).text() + "\n");
  write_file(folder + "/tables.txt", all_tables(work));
}

Json study_json(const Work& work, const Experiment& experiment) {
  const StudyRequest& request = *work.study;
  Json json = Json::object()
                  .set("file", work.file)
                  .set("task", request.task)
                  .set("trials_of", request.trials.empty() ? "simulated operators" : request.trials)
                  .set("rule", experiment.errors.rule)
                  .set("remarks", Json::list_of(experiment.remarks))
                  .set("trials", trials_json(experiment));
  if (!experiment.runs.empty())
    json.set("seed", experiment.seed).set("orders", orders_json(experiment, request));
  if (experiment.analysis) json.set("analysis", analysis_json(*experiment.analysis, request));
  return json;
}

std::string study_text(const Work& work, const Experiment& experiment) {
  const StudyRequest& request = *work.study;
  std::string result =
      fmt::format("study: task {}, {} subjects, {} trials ({})\n", request.task,
                  request.subject_names().size(), experiment.trials.size(), whose_trials(request));
  for (const std::string& remark : experiment.remarks) result += fmt::format("  note {}\n", remark);
  for (const NamedTable& one : work.tables)
    if (one.name == "means" || one.name == "significance") result += "\n" + text(*one.table);
  return result + "\n";
}

}  // namespace stepwire

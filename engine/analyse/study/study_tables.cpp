#include "engine/analyse/study/study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/study/comparison_tables.hpp"
#include "engine/analyse/study/distribution.hpp"
#include "engine/analyse/study/side_by_side.hpp"

namespace stepwire::study {

namespace {

std::string shown(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.4f}", value);
}

/// Returns the thesis' tables 3 and 5: a line per condition, a column per subject, and the published values.
text::TextTable subjects_table(const Experiment& experiment, const StudyRequest& request) {
  text::TextTable table{"Normalised errors of task " + request.task, {"condition"}, {}, {}};
  for (const std::string& subject : request.subject_names()) table.columns.push_back(subject);
  for (const PublishedValues& example : request.published.examples)
    table.columns.push_back("published, " + example.source);
  for (const std::string& condition : request.condition_names()) {
    std::vector<std::string> row{condition};
    for (const std::string& subject : request.subject_names()) {
      const auto& rows = experiment.errors.rows;
      const auto found = std::find_if(rows.begin(), rows.end(), [&](const PathError& error) {
        return error.subject == subject && error.condition == condition;
      });
      row.push_back(found == rows.end() ? "–" : shown(found->normalised));
    }
    for (const PublishedValues& example : request.published.examples)
      row.push_back(shown(value_of(example.values, condition)));
    table.rows.push_back(std::move(row));
  }
  table.notes = {"Normalised: " + experiment.errors.rule + ". Subjects by number: " + whose_trials(request) +
                 "."};
  return table;
}

text::TextTable none(const std::string& title, const std::string& why) {
  return {title, {"not analysed"}, {}, {why}};
}

text::TextTable table_of(const std::string& name, const Experiment& experiment, const StudyRequest& request) {
  if (name == "errors") return error_summary(experiment.errors);
  if (name == "subjects") return subjects_table(experiment, request);
  if (name.starts_with("experiments") && experiment.others.empty())
    return none("Experiments of task " + request.task,
                "One experiment has no distribution; `experiments: 20` or --repeat 20 performs others.");
  if (name == "experiments") return experiments_table(outcomes(experiment, request), request);
  if (name == "experiments_significance")
    return experiments_significance_table(outcomes(experiment, request), request);
  const std::string of = " of task " + request.task;
  if (!experiment.analysis) return none("Analysis" + of, experiment.not_analysed);
  const TaskAnalysis& analysis = *experiment.analysis;
  if (name == "anova") return anova_table(analysis.additive, "Analysis of variance" + of);
  if (name == "anova_with_subject")
    return anova_table(analysis.with_subject, "Analysis of variance" + of + ", with the subject as a factor");
  if (name == "repeated_measures")
    return analysis.repeated ? anova_table(*analysis.repeated, "Repeated measures" + of)
                             : none("Repeated measures" + of, analysis.not_repeated);
  if (name == "means")
    return side_by_side_table(
        compare_errors(request.published.means, analysis.means, request.published.order));
  const auto& compared = comparison_table_names();
  if (std::find(compared.begin(), compared.end(), name) != compared.end())
    return analysis.within ? comparison_table(name, *analysis.within, of, experiment.seed)
                           : none("Within subjects" + of, analysis.not_within);
  return side_by_side_table(compare_significance(request.published, analysis));
}

}  // namespace

std::vector<query::NamedTable> empty_study_tables() {
  std::vector<query::NamedTable> tables;
  for (const char* name : {"errors", "subjects", "anova", "anova_with_subject", "repeated_measures", "means",
                           "significance", "experiments", "experiments_significance"})
    tables.push_back({name, std::make_shared<text::TextTable>()});
  for (const std::string& name : comparison_table_names())
    tables.push_back({name, std::make_shared<text::TextTable>()});
  return tables;
}

void fill_study_tables(const Experiment& experiment, const StudyRequest& request,
                       std::vector<query::NamedTable>& tables) {
  for (query::NamedTable& one : tables) {
    *one.table = table_of(one.name, experiment, request);
    if (!experiment.others.empty() && !one.name.starts_with("experiments"))
      one.table->title +=
          fmt::format(" of experiment 1 of {} (seed {})", experiment.others.size() + 1, experiment.seed);
    one.table->title += fmt::format(" ({})", whose_trials(request));
  }
}

std::string whose_trials(const StudyRequest& request) {
  return request.trials.empty() ? "simulated operators" : "recorded trials";
}

}  // namespace stepwire::study

#include "engine/analyse/study/study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/study/comparison_tables.hpp"
#include "engine/analyse/study/distribution.hpp"
#include "engine/analyse/study/side_by_side.hpp"
#include "engine/base/text/count.hpp"
#include "engine/simulate/run/pooling.hpp"

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
  return side_by_side_table(compare_significance(request.published, analysis, request.factored()));
}

/// Columns for the swept values that distinguish the points: as few axes as possible, one with `together`.
/// The other values of each point are in notes.
class PointColumns {
 public:
  explicit PointColumns(const Experiments& experiments) : experiments_(experiments) {
    std::vector<std::vector<diagram::Setting>> points;
    for (const Experiment& experiment : experiments) points.push_back(experiment.sets);
    count_ = run::telling_settings(points);
  }

  std::vector<std::string> names() const { return texts(experiments_.front(), &diagram::Setting::name); }
  std::vector<std::string> values(const Experiment& experiment) const {
    return texts(experiment, &diagram::Setting::value);
  }

  /// Returns "D1: offset=8 N, spread=0.5" for each point; empty if the columns have all values.
  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    if (count_ == experiments_.front().sets.size()) return notes;
    for (const Experiment& experiment : experiments_) {
      const auto rest = experiment.sets.begin() + static_cast<std::ptrdiff_t>(count_);
      notes.push_back(fmt::format("{}: {}.", fmt::join(values(experiment), ", "),
                                  run::settings_text({rest, experiment.sets.end()})));
    }
    return notes;
  }

 private:
  std::vector<std::string> texts(const Experiment& experiment, std::string diagram::Setting::*part) const {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < count_; ++i) result.push_back(experiment.sets[i].*part);
    return result;
  }

  const Experiments& experiments_;
  std::size_t count_ = 0;
};

/// Contents of a line for one experiment: values of the thesis and ours, and statements.
struct Shown {
  std::vector<ComparedValue> values;
  std::vector<Agreement> statements;
};

bool has_published(const StudyRequest& request) {
  return !request.published.means.values.empty() || !request.published.probabilities.values.empty();
}

Shown shown_means(const StudyRequest& request, const TaskAnalysis& analysis) {
  const PublishedStudy& published = request.published;
  Shown shown;
  for (const std::string& condition : request.condition_names())
    shown.values.push_back(
        {condition, value_of(published.means.values, condition), value_of(analysis.means, condition)});
  shown.statements = judge_orders(published.order, analysis.means);
  return shown;
}

Shown shown_significance(const StudyRequest& request, const TaskAnalysis& analysis) {
  SideBySide both = compare_significance(request.published, analysis, request.factored());
  return {std::move(both.values), std::move(both.agreements)};
}

/// Adds the head of a table. Statements such as "order NO > H > V > HV" are too long for a column. They are
/// numbered, and the notes list them.
void add_head(const Shown& shown, text::TextTable& table) {
  for (const ComparedValue& value : shown.values) table.columns.push_back(value.name);
  for (std::size_t i = 0; i < shown.statements.size(); ++i) {
    table.columns.push_back(fmt::format("({})", i + 1));
    table.notes.push_back(fmt::format("({}) Published: {}.", i + 1, shown.statements[i].that));
  }
}

void add_line(const Shown& shown, std::vector<std::string> line, text::TextTable& table) {
  for (const ComparedValue& value : shown.values) line.push_back(printed_probability(value.ours));
  for (const Agreement& one : shown.statements) line.emplace_back(one.agrees ? "holds" : "fails");
  table.rows.push_back(std::move(line));
}

text::TextTable table_of(const std::string& title,
                         Shown (*shown_of)(const StudyRequest&, const TaskAnalysis&),
                         const Experiments& experiments, const StudyRequest& request) {
  const PointColumns points(experiments);
  text::TextTable table{title, points.names(), {}, {}};
  const std::size_t swept = table.columns.size();
  Shown first;
  for (const Experiment& experiment : experiments) {
    const auto& analysis = experiment.analysis;
    const Shown shown = analysis ? shown_of(request, *analysis) : Shown{};
    if (table.columns.size() == swept && analysis) add_head(first = shown, table);
    add_line(shown, points.values(experiment), table);
    if (!analysis)
      table.notes.push_back(fmt::format("Not analysed with {}: {}.", run::settings_text(experiment.sets),
                                        experiment.not_analysed));
  }
  std::vector<std::string> published{"published"};
  published.resize(swept);
  for (const ComparedValue& value : first.values) published.push_back(printed_probability(value.published));
  if (has_published(request)) table.rows.push_back(std::move(published));
  for (auto& row : table.rows) row.resize(table.columns.size(), "–");
  for (std::string& note : points.notes()) table.notes.push_back(std::move(note));
  return table;
}

/// Concatenates the tables of all points; each row begins with its point.
text::TextTable stacked(std::size_t which, const std::vector<std::vector<query::NamedTable>>& of_points,
                        const Experiments& experiments) {
  const PointColumns points(experiments);
  text::TextTable all{of_points.front()[which].table->title, points.names(), {}, {}};
  const auto longest = std::ranges::max_element(
      of_points, {}, [&](const auto& tables) { return tables[which].table->columns.size(); });
  const std::vector<std::string>& columns = (*longest)[which].table->columns;
  all.columns.insert(all.columns.end(), columns.begin(), columns.end());
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    const text::TextTable& one = *of_points[i][which].table;
    for (const auto& row : one.rows) {
      std::vector<std::string> line = points.values(experiments[i]);
      line.insert(line.end(), row.begin(), row.end());
      line.resize(all.columns.size());
      all.rows.push_back(std::move(line));
    }
    for (const std::string& note : one.notes) {
      const std::string told = fmt::format("{}: {}", fmt::join(points.values(experiments[i]), ", "), note);
      const bool is_new = std::ranges::find(all.notes, note) == all.notes.end();
      if (i == 0 || is_new) all.notes.push_back(i == 0 ? note : told);
    }
  }
  return all;
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

void fill_sweep_tables(const Experiments& experiments, const StudyRequest& request,
                       std::vector<query::NamedTable>& tables) {
  const Experiment& first = experiments.front();
  const std::string which = first.others.empty() ? ""
                                                 : fmt::format(", of experiment 1 of {} (seed {})",
                                                               first.others.size() + 1, first.seed);
  const std::string of =
      fmt::format(" of task {}, {}{} ({})", request.task, text::counted(request.subjects.size(), "subject"),
                  which, whose_trials(request));
  std::vector<std::vector<query::NamedTable>> of_points;
  for (const Experiment& experiment : experiments)
    fill_study_tables(experiment, request, of_points.emplace_back(empty_study_tables()));
  for (std::size_t i = 0; i < tables.size(); ++i)
    *tables[i].table = tables[i].name == "means"
                           ? table_of("Mean normalised errors" + of, shown_means, experiments, request)
                       : tables[i].name == "significance"
                           ? table_of("Significance (P)" + of, shown_significance, experiments, request)
                           : stacked(i, of_points, experiments);
}

}  // namespace stepwire::study

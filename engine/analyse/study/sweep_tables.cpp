// What the studies of a sweep say, a line for each.
#include <fmt/format.h>

#include "engine/analyse/study/side_by_side.hpp"
#include "engine/analyse/study/study_tables.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::study {

namespace {

/// What a table of the sweep shows of one experiment: the thesis' values and ours, and what it states.
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
  SideBySide both = compare_significance(request.published, analysis);
  return {std::move(both.values), std::move(both.agreements)};
}

/// "(1) order NO > H > V > HV" needs more room than a column has: the statements are numbered, and told
/// below.
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
  text::TextTable table{title, {}, {}, {}};
  for (const diagram::Setting& setting : experiments.front().sets) table.columns.push_back(setting.name);
  const std::size_t swept = table.columns.size();
  Shown first;
  for (const Experiment& experiment : experiments) {
    const auto& analysis = experiment.analysis;
    const Shown shown = analysis ? shown_of(request, *analysis) : Shown{};
    if (table.columns.size() == swept && analysis) add_head(first = shown, table);
    std::vector<std::string> line;
    for (const diagram::Setting& setting : experiment.sets) line.push_back(setting.value);
    add_line(shown, std::move(line), table);
    if (!analysis)
      table.notes.push_back(fmt::format("Not analysed with {}: {}.", run::settings_text(experiment.sets),
                                        experiment.not_analysed));
  }
  std::vector<std::string> published{"published"};
  published.resize(swept);
  for (const ComparedValue& value : first.values) published.push_back(printed_probability(value.published));
  if (has_published(request)) table.rows.push_back(std::move(published));
  for (auto& row : table.rows) row.resize(table.columns.size(), "–");
  return table;
}

}  // namespace

void fill_sweep_tables(const Experiments& experiments, const StudyRequest& request,
                       std::vector<query::NamedTable>& tables) {
  const Experiment& first = experiments.front();
  const std::string which = first.others.empty() ? ""
                                                 : fmt::format(", of experiment 1 of {} (seed {})",
                                                               first.others.size() + 1, first.seed);
  const std::string of = fmt::format(" of task {}, {} subjects{} ({})", request.task, request.subjects.size(),
                                     which, whose_trials(request));
  for (query::NamedTable& one : tables)
    *one.table = one.name == "means"
                     ? table_of("Mean normalised errors" + of, shown_means, experiments, request)
                     : table_of("Significance (P)" + of, shown_significance, experiments, request);
}

}  // namespace stepwire::study

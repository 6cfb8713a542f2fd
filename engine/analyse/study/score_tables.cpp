// The analysis of a table of scores, as tables and as JSON.
#include <fmt/format.h>

#include <cmath>

#include "engine/analyse/statistics/moments.hpp"
#include "engine/analyse/study/analysis.hpp"
#include "engine/analyse/study/comparison_tables.hpp"
#include "engine/analyse/study/scores.hpp"

namespace stepwire::study {

using json::Json;

namespace {

double mean_of(const statistics::Cell& cell) {
  return statistics::moments_of(cell.values).mean;
}

/// Returns the standard deviation of the sample; nan for a single value.
double deviation_of(const statistics::Cell& cell) {
  return std::sqrt(statistics::moments_of(cell.values).squares /
                   (static_cast<double>(cell.values.size()) - 1.0));
}

std::string shown_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "–";
}

text::TextTable cell_table(const ScoresAnalysis& analysis) {
  text::TextTable table{"Cells of " + analysis.observations.response, analysis.request.factors, {}, {}};
  table.columns.insert(table.columns.end(), {"scores", "mean", "standard deviation"});
  for (const statistics::Cell& cell : cells(analysis.observations, analysis.request.factors)) {
    std::vector<std::string> row;
    for (std::size_t k = 0; k < cell.levels.size(); ++k)
      row.push_back(analysis.observations.factor(analysis.request.factors[k]).levels[cell.levels[k]]);
    row.push_back(std::to_string(cell.values.size()));
    row.push_back(cell.values.empty() ? "–" : shown_number(mean_of(cell)));
    row.push_back(cell.values.size() < 2 ? "–" : shown_number(deviation_of(cell)));
    table.rows.push_back(std::move(row));
  }
  for (const std::string& one : analysis.left_out) table.notes.push_back("Left out: " + one + ".");
  return table;
}

text::TextTable groups_table(const ScoresAnalysis& analysis) {
  text::TextTable table{
      "Comparisons of groups",
      {"pair", "mean difference", "from", "to", "t", "degrees of freedom", "P", "P (Holm)"},
      {},
      {fmt::format("First minus second. Independent scores: t test of Welch, whose variances may "
                   "differ; from, to: at 95 % confidence, uncorrected. P (Holm): corrected for {} "
                   "comparison{}.",
                   analysis.groups.size(), analysis.groups.size() == 1 ? "" : "s")}};
  for (const statistics::IndependentPair& pair : analysis.groups)
    table.rows.push_back({pair.first + " - " + pair.second, shown_number(pair.difference),
                          shown_number(pair.interval.low), shown_number(pair.interval.high),
                          shown_number(pair.t), shown_number(pair.freedom), printed_probability(pair.p),
                          printed_probability(pair.holm)});
  return table;
}

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json groups_json(const ScoresAnalysis& analysis) {
  if (analysis.groups.empty()) return {};
  Json list = Json::list();
  for (const statistics::IndependentPair& pair : analysis.groups)
    list.push(Json::object()
                  .set("first", pair.first)
                  .set("second", pair.second)
                  .set("difference", pair.difference)
                  .set("low", number_or_null(pair.interval.low))
                  .set("high", number_or_null(pair.interval.high))
                  .set("t", number_or_null(pair.t))
                  .set("degrees_of_freedom", number_or_null(pair.freedom))
                  .set("P", number_or_null(pair.p))
                  .set("P_holm", number_or_null(pair.holm)));
  return list;
}

std::string listed_names(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

Json cells_json(const ScoresAnalysis& analysis) {
  Json list = Json::list();
  for (const statistics::Cell& cell : cells(analysis.observations, analysis.request.factors)) {
    Json levels = Json::object();
    for (std::size_t k = 0; k < cell.levels.size(); ++k)
      levels.set(analysis.request.factors[k],
                 analysis.observations.factor(analysis.request.factors[k]).levels[cell.levels[k]]);
    list.push(Json::object()
                  .set("levels", std::move(levels))
                  .set("scores", cell.values.size())
                  .set("mean", cell.values.empty() ? Json() : Json(mean_of(cell)))
                  .set("standard_deviation", cell.values.size() < 2 ? Json() : Json(deviation_of(cell))));
  }
  return list;
}

}  // namespace

std::vector<text::TextTable> score_tables(const ScoresAnalysis& analysis) {
  const bool subjects = !analysis.request.subject.empty();
  std::vector<text::TextTable> tables{cell_table(analysis)};
  tables.push_back(anova_table(analysis.anova, subjects ? "Repeated measures" : "Analysis of variance"));
  if (subjects)
    tables.back().notes.push_back(fmt::format("Within subjects: {}. Between subjects: {}.",
                                              listed_names(analysis.within), listed_names(analysis.between)));
  if (!analysis.groups.empty()) tables.push_back(groups_table(analysis));
  if (!analysis.pairs) return tables;
  for (const std::string& name : comparison_table_names())
    if (name != "power" || analysis.request.power_seed)
      tables.push_back(comparison_table(name, *analysis.pairs, "", analysis.request.power_seed.value_or(1)));
  return tables;
}

Json scores_json(const std::string& path, const ScoresAnalysis& analysis) {
  const statistics::Anova& anova = analysis.anova;
  const bool subjects = !analysis.request.subject.empty();
  return Json::object()
      .set("file", path)
      .set("score", analysis.request.score)
      .set("subject", subjects ? Json(analysis.request.subject) : Json())
      .set("within", Json::list_of(analysis.within))
      .set("between", Json::list_of(analysis.between))
      .set("left_out", Json::list_of(analysis.left_out))
      .set("cells", cells_json(analysis))
      .set(subjects ? "repeated_measures" : "anova", anova_json(anova))
      .set("r_squared",
           subjects ? Json() : Json(1.0 - anova.residual.sum_of_squares / anova.total.sum_of_squares))
      .set("residual_deviation", subjects ? Json() : Json(std::sqrt(anova.residual.mean_square)))
      .set("groups", groups_json(analysis))
      .set("within_subjects",
           analysis.pairs ? comparisons_json(*analysis.pairs, analysis.request.power_seed) : Json());
}

}  // namespace stepwire::study

#include "engine/analyse/study/analysis.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/repeated_measures.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::study {

using json::Json;

namespace {

/// Returns the factors of the conditions.
std::vector<std::string> own_factors(const statistics::Observations& observations) {
  std::vector<std::string> names;
  for (const statistics::Factor& factor : observations.factors)
    if (!factor.subject && factor.name != "condition") names.push_back(factor.name);
  return names;
}

bool all_combined(const statistics::Observations& observations, const std::vector<std::string>& factors) {
  const auto all = cells(observations, factors);
  return std::none_of(all.begin(), all.end(),
                      [](const statistics::Cell& cell) { return cell.values.empty(); });
}

std::vector<std::vector<double>> by_condition(const PathErrors& errors) {
  const auto conditions = errors.conditions();
  std::vector<std::vector<double>> samples(conditions.size());
  for (const PathError& row : errors.rows) {
    const auto at = std::find(conditions.begin(), conditions.end(), row.condition);
    samples[static_cast<std::size_t>(at - conditions.begin())].push_back(row.normalised);
  }
  return samples;
}

/// Returns 1 for each condition with the factor, else 0.
Eigen::VectorXd presence(const std::vector<NamedValue>& means, const std::vector<Condition>& conditions,
                         const std::string& factor) {
  Eigen::VectorXd present = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(means.size()));
  for (std::size_t i = 0; i < means.size(); ++i)
    for (const Condition& condition : conditions)
      if (condition.name == means[i].name && condition.has(factor))
        present[static_cast<Eigen::Index>(i)] = 1.0;
  return present;
}

std::string number(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.4g}", value);
}

void add_row(text::TextTable& table, const statistics::AnovaRow& row, bool spherical) {
  std::vector<std::string> cells{
      row.name,      number(row.sum_of_squares), fmt::format("{:g}", row.freedom), number(row.mean_square),
      number(row.f), printed_probability(row.p), number(row.partial_eta_squared)};
  const auto add_correction = [&](double epsilon, double p) {
    cells.push_back(std::isnan(epsilon) ? "–" : fmt::format("{:.3f}", epsilon));
    cells.push_back(printed_probability(p));
  };
  if (spherical && row.sphericity) {
    add_correction(row.sphericity->epsilon, row.sphericity->p_corrected);
    add_correction(row.sphericity->huynh_feldt, row.sphericity->p_huynh_feldt);
  } else if (spherical) {
    cells.insert(cells.end(), 4, "–");
  }
  table.rows.push_back(std::move(cells));
}

}  // namespace

Json sphericity_json(const statistics::Sphericity& of) {
  return Json::object()
      .set("mauchly_W", of.mauchly)
      .set("mauchly_P", of.p_mauchly)
      .set("epsilon_greenhouse_geisser", of.epsilon)
      .set("P_greenhouse_geisser", of.p_corrected)
      .set("epsilon_huynh_feldt", of.huynh_feldt)
      .set("P_huynh_feldt", of.p_huynh_feldt);
}

namespace {

Json row_json(const statistics::AnovaRow& row) {
  Json json = Json::object()
                  .set("name", row.name)
                  .set("sum_of_squares", row.sum_of_squares)
                  .set("degrees_of_freedom", row.freedom)
                  .set("mean_square", row.mean_square)
                  .set("F", row.f)
                  .set("P", row.p)
                  .set("partial_eta_squared", row.partial_eta_squared)
                  .set("against", row.against);
  if (row.sphericity) json.set("sphericity", sphericity_json(*row.sphericity));
  return json;
}

/// Adds the analyses within subjects, or the reason why there are none.
void add_within_subjects(const statistics::Observations& all, const std::vector<std::string>& factors,
                         const std::vector<std::string>& order, TaskAnalysis& result) {
  try {
    result.repeated = statistics::repeated_measures(all, factors, "subject");
  } catch (const statistics::StatisticsError& error) {
    result.not_repeated = error.what();
  }
  try {
    result.within = statistics::within_subjects(all, factors, order, "condition", "subject");
  } catch (const statistics::StatisticsError& error) {
    result.not_within = error.what();
  }
}

std::vector<std::string> names_of(const std::vector<Condition>& conditions) {
  std::vector<std::string> names;
  for (const Condition& condition : conditions) names.push_back(condition.name);
  return names;
}

}  // namespace

double value_of(const std::vector<NamedValue>& values, const std::string& name) {
  const auto found =
      std::find_if(values.begin(), values.end(), [&](const NamedValue& value) { return value.name == name; });
  return found == values.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

std::string printed_probability(double p) {
  if (std::isnan(p)) return "–";
  return p < 1e-3 ? fmt::format("{:.2e}", p) : fmt::format("{:.3g}", p);
}

std::vector<NamedValue> factor_effects(const std::vector<NamedValue>& means,
                                       const std::vector<Condition>& conditions) {
  if (means.empty()) return {};
  const auto rows = static_cast<Eigen::Index>(means.size());
  Eigen::MatrixXd terms = Eigen::MatrixXd::Ones(rows, 1);
  Eigen::VectorXd errors(rows);
  for (Eigen::Index row = 0; row < rows; ++row) errors[row] = means[static_cast<std::size_t>(row)].value;
  std::vector<NamedValue> effects;
  for (const std::string& name : factors_of(conditions)) {
    const Eigen::VectorXd present = presence(means, conditions, name);
    if (present.minCoeff() == present.maxCoeff()) continue;  // present in all conditions or in none
    terms.conservativeResize(Eigen::NoChange, terms.cols() + 1);
    terms.rightCols(1) = present;
    effects.push_back({name, std::numeric_limits<double>::quiet_NaN()});
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(terms);
  if (solver.rank() < terms.cols()) return effects;
  const Eigen::VectorXd found = solver.solve(errors);
  for (std::size_t i = 0; i < effects.size(); ++i) effects[i].value = found[static_cast<Eigen::Index>(i) + 1];
  return effects;
}

TaskAnalysis analyse(const PathErrors& errors, const std::vector<Condition>& conditions) {
  const statistics::Observations all = observations(errors, conditions);
  const auto factors = own_factors(all);
  TaskAnalysis result;
  const auto names = errors.conditions();
  const auto samples = by_condition(errors);
  for (std::size_t i = 0; i < names.size(); ++i)
    result.means.push_back({names[i], statistics::box_summary(samples[i]).mean});
  result.effects = factor_effects(result.means, conditions);
  result.additive = statistics::anova(all, statistics::additive_terms(factors));
  auto with_subject = statistics::additive_terms(factors);
  with_subject.push_back({{"subject"}, {}});
  result.with_subject = statistics::anova(all, with_subject);
  const bool crossed = all_combined(all, factors);
  add_within_subjects(all, crossed ? factors : std::vector<std::string>{"condition"}, names_of(conditions),
                      result);
  return result;
}

text::TextTable anova_table(const statistics::Anova& anova, const std::string& title) {
  text::TextTable table{
      title, {"term", "sum of squares", "df", "mean square", "F", "P", "partial η²"}, {}, {}};
  const bool spherical =
      std::any_of(anova.terms.begin(), anova.terms.end(),
                  [](const statistics::AnovaRow& row) { return row.sphericity.has_value(); });
  if (spherical) table.columns.insert(table.columns.end(), {"ε (GG)", "P (GG)", "ε (HF)", "P (HF)"});
  for (const statistics::AnovaRow& row : anova.terms) add_row(table, row, spherical);
  if (anova.residual.freedom > 0.0) add_row(table, anova.residual, spherical);
  add_row(table, anova.total, spherical);
  table.notes.push_back(fmt::format("Response: {}; {} ({}). Sums of squares: {}.", anova.response,
                                    anova.design, anova.balanced ? "balanced" : "not balanced",
                                    statistics::words_of(anova.sums)));
  for (const std::string& warning : anova.warnings) table.notes.push_back("Mind: " + warning + ".");
  return table;
}

Json anova_json(const statistics::Anova& anova) {
  Json terms = Json::list();
  for (const statistics::AnovaRow& row : anova.terms) terms.push(row_json(row));
  return Json::object()
      .set("response", anova.response)
      .set("design", anova.design)
      .set("balanced", anova.balanced)
      .set("sums_of_squares", statistics::words_of(anova.sums))
      .set("terms", std::move(terms))
      .set("residual", row_json(anova.residual))
      .set("total", row_json(anova.total))
      .set("warnings", Json::list_of(anova.warnings));
}

text::TextTable error_summary(const PathErrors& errors) {
  text::TextTable table{
      "Path errors of task " + errors.task,
      {"condition", "trials", "mean", "least", "lower quartile", "median", "upper quartile", "largest"},
      {},
      {"Normalised: " + errors.rule + "."}};
  const auto names = errors.conditions();
  const auto samples = by_condition(errors);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const statistics::BoxSummary box = statistics::box_summary(samples[i]);
    table.rows.push_back({names[i], std::to_string(samples[i].size())});
    for (const double value : {box.mean, box.min, box.lower, box.median, box.upper, box.max})
      table.rows.back().push_back(fmt::format("{:.3f}", value));
  }
  return table;
}

}  // namespace stepwire::study

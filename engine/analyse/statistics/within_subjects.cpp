#include "engine/analyse/statistics/within_subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/contrasts.hpp"
#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/repeated_measures.hpp"
#include "engine/analyse/statistics/rounding.hpp"

namespace stepwire::statistics {
namespace {

ConfidenceInterval interval_about(const Eigen::VectorXd& values, double mean, double widening) {
  const auto count = static_cast<double>(values.size());
  const double variance = moments_of({values.begin(), values.end()}).squares / (count - 1.0);
  return student_interval(mean, widening * std::sqrt(variance / count), count - 1.0);
}

PairComparison compared(const ConditionTable& table, std::size_t first, std::size_t second) {
  const auto differences = table.differences(first, second);
  PairComparison comparison;
  comparison.first = table.conditions[first], comparison.second = table.conditions[second];
  comparison.test = paired_test(differences);
  comparison.ranks = signed_rank_test(differences);
  comparison.effect = paired_effect(table.column(first), table.column(second));
  comparison.normality = shapiro_wilk(differences);
  return comparison;
}

void correct(std::vector<PairComparison>& comparisons) {
  std::vector<double> p, of_ranks;
  for (const PairComparison& one : comparisons) p.push_back(one.test.p), of_ranks.push_back(one.ranks.p);
  p = holm_corrected(p), of_ranks = holm_corrected(of_ranks);
  for (std::size_t i = 0; i < comparisons.size(); ++i)
    comparisons[i].holm = p[i], comparisons[i].ranks_holm = of_ranks[i];
}

/// Returns the residuals of the model subject + condition; empty if they are rounding error.
std::vector<double> residuals_of(const Eigen::MatrixXd& values) {
  const Eigen::MatrixXd above = values.array() - values(0, 0);  // keeps the digits of a large mean
  const Eigen::MatrixXd by_subject = above.colwise() - above.rowwise().mean();
  const Eigen::MatrixXd rest = by_subject.rowwise() - by_subject.colwise().mean();
  if (is_rounding(rest.norm(), values.norm())) return {};
  return {rest.data(), rest.data() + rest.size()};
}

PowerRow power_of(const std::string& name, const Eigen::MatrixXd& scores, const PowerSimulation& simulation) {
  const auto subjects = static_cast<std::size_t>(scores.rows());
  PowerRow row{name, no_number, no_number, no_number, {}, {}, false};
  if (scores.cols() == 1) {
    const PairedTest test = paired_test({scores.data(), scores.data() + scores.size()});
    row.d_z = test.deviation > 0.0 ? test.mean / test.deviation : no_number;
    row.power = paired_power(row.d_z, subjects);
    row.needed = subjects_needed(row.d_z);
  }
  const auto simulated = simulated_power(scores, simulation);
  if (subjects < simulated.size()) row.simulated = simulated[subjects];
  row.simulation_possible = !simulated.empty();
  row.needed_simulated = subjects_needed(simulated);
  return row;
}

/// Returns the factors in the name of a term: "haptic:visual".
std::vector<std::string> factors_in(const std::string& term) {
  std::vector<std::string> factors;
  for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 1) {
    to = term.find(':', from);
    factors.push_back(term.substr(from, to - from));
  }
  return factors;
}

std::string subject_of(const Observations& observations) {
  for (const Factor& factor : observations.factors)
    if (factor.subject) return factor.name;
  return "subject";
}

}  // namespace

std::vector<MeanInterval> mean_intervals(const Eigen::MatrixXd& values) {
  const auto conditions = static_cast<double>(values.cols());
  const Eigen::MatrixXd above = values.array() - values(0, 0);  // keeps the digits of a large mean
  const Eigen::MatrixXd normalised = above.colwise() - above.rowwise().mean();
  std::vector<MeanInterval> result;
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    const double mean = moments_of({values.col(k).begin(), values.col(k).end()}).mean;
    MeanInterval interval{mean, interval_about(values.col(k), mean, 1.0), {no_number, no_number}};
    if (values.cols() > 1)
      interval.within_subject =
          interval_about(normalised.col(k), mean, std::sqrt(conditions / (conditions - 1.0)));
    result.push_back(interval);
  }
  return result;
}

WithinSubjects within_subjects(const Observations& observations, const std::vector<std::string>& factors,
                               const std::vector<std::string>& order, const std::string& condition,
                               const std::string& subject) {
  WithinSubjects within;
  within.table = condition_table(observations, condition, subject, order);
  within.factors = factors;
  within.means = mean_intervals(within.table.values);
  std::vector<std::vector<double>> groups;
  for (std::size_t first = 0; first < within.table.conditions.size(); ++first) {
    groups.push_back(within.table.column(first));
    for (std::size_t second = first + 1; second < within.table.conditions.size(); ++second)
      within.comparisons.push_back(compared(within.table, first, second));
  }
  correct(within.comparisons);
  within.repeated = repeated_measures(within.table.observations, factors, subject);
  within.effects = term_effects(within.repeated);
  // Few residuals are tied to each other by the means that are taken out: those of two subjects under two
  // conditions all have one size.
  constexpr Eigen::Index least_freedom = 3;
  const Eigen::MatrixXd& values = within.table.values;
  if ((values.rows() - 1) * (values.cols() - 1) >= least_freedom)
    within.residuals = shapiro_wilk(residuals_of(values));
  within.variances = variance_test(groups);
  return within;
}

std::vector<PowerRow> power_rows(const WithinSubjects& within, const PowerSimulation& simulation) {
  std::vector<PowerRow> rows;
  for (const PairComparison& one : within.comparisons) {
    const auto& names = within.table.conditions;
    const auto at = [&](const std::string& name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const auto differences = within.table.differences(at(one.first), at(one.second));
    const Eigen::Map<const Eigen::VectorXd> scores(differences.data(),
                                                   static_cast<Eigen::Index>(differences.size()));
    rows.push_back(power_of(fmt::format("{} - {}", one.first, one.second), scores, simulation));
  }
  const Observations& observations = within.table.observations;
  const Eigen::MatrixXd means = cell_means(observations, within.factors, subject_of(observations));
  for (const TermEffect& effect : within.effects) {
    PowerSimulation corrected = simulation;
    if (const auto& sphericity = within.repeated.find(effect.term)->sphericity)
      corrected.epsilon = sphericity->epsilon;
    const Eigen::MatrixXd scores =
        means * contrasts_of(factors_in(effect.term), observations, within.factors);
    rows.push_back(power_of(effect.term, scores, corrected));
  }
  return rows;
}

}  // namespace stepwire::statistics

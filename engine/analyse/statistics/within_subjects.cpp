#include "engine/analyse/statistics/within_subjects.hpp"

#include "engine/analyse/statistics/holm.hpp"
#include "engine/analyse/statistics/repeated_measures.hpp"
#include "engine/analyse/statistics/rounding.hpp"

namespace stepwire::statistics {
namespace {

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

}  // namespace

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

}  // namespace stepwire::statistics

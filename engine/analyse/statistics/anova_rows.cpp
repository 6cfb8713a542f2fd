#include "engine/analyse/statistics/anova_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/equal_variances.hpp"
#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/tail.hpp"

namespace stepwire::statistics {

double beyond_rounding(double sum, double all) {
  return is_rounding(std::sqrt(sum), std::sqrt(all)) ? 0.0 : sum;
}

AnovaRow anova_row(const std::string& name, double freedom, double sum) {
  return {name, freedom, sum, freedom > 0.0 ? sum / freedom : no_number, no_number, no_number, no_number, ""};
}

void judge(AnovaRow& row, const AnovaRow& error) {
  row.against = error.name;
  if (row.freedom <= 0.0 || error.freedom <= 0.0) return;
  if (error.sum_of_squares <= 0.0) return;  // no error variance: F is undefined
  row.f = row.mean_square / error.mean_square;
  row.p = fisher_tail(row.f, row.freedom, error.freedom);
  row.partial_eta_squared = row.sum_of_squares / (row.sum_of_squares + error.sum_of_squares);
}

void warn_of_missing_f(Anova& result) {
  std::vector<std::string> names;
  for (const AnovaRow& row : result.terms) {
    const AnovaRow* error = row.against == result.residual.name ? &result.residual : result.find(row.against);
    if (error && row.freedom > 0.0 && error->freedom > 0.0 && std::isnan(row.f)) names.push_back(row.name);
  }
  if (!names.empty())
    result.warnings.push_back(
        fmt::format("F of {} has no value: what it is compared with varies by no more than rounding",
                    fmt::join(names, ", ")));
}

void describe_design(Anova& result, const Observations& observations, const std::vector<std::string>& names) {
  const auto all = cells(observations, names);
  std::size_t least = observations.values.size(), most = 0, empty = 0;
  for (const Cell& cell : all) {
    if (cell.values.empty()) ++empty;
    most = std::max(most, cell.values.size());
    if (!cell.values.empty()) least = std::min(least, cell.values.size());
  }
  result.balanced = empty == 0 && least == most;
  const std::string each = least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most);
  result.design =
      fmt::format("{} values in {} cells of {}", observations.values.size(), all.size() - empty, each);
  if (empty > 0) result.design += fmt::format("; {} of {} combinations were not observed", empty, all.size());
}

void warn_of_variances(Anova& result, const Observations& observations,
                       const std::vector<std::string>& names) {
  std::vector<std::vector<double>> groups;
  for (Cell& cell : cells(observations, names)) groups.push_back(std::move(cell.values));
  const auto test = variance_test(groups);
  if (test && test->p < 0.05)
    result.warnings.push_back(fmt::format(
        "the variances of the cells differ (Brown-Forsythe F({:g}, {:g}) = {:.3g}, P = {:.2g}); an "
        "analysis of variance takes them for equal",
        test->above, test->below, test->f, test->p));
}

}  // namespace stepwire::statistics

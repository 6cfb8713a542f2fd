#include "engine/analyse/statistics/condition_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/statistics/contrasts.hpp"
#include "engine/analyse/statistics/rounding.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"

namespace stepwire::statistics {
namespace {

/// Returns the observations at some levels of a factor; the factor keeps these levels only, in this order.
Observations kept(const Observations& observations, const std::string& name,
                  const std::vector<std::string>& levels) {
  const Factor& by = observations.factor(name);
  Observations result{observations.response, {}, observations.factors};
  for (Factor& factor : result.factors) factor.level.clear();
  for (std::size_t row = 0; row < observations.values.size(); ++row) {
    const auto found = std::find(levels.begin(), levels.end(), by.levels[by.level[row]]);
    if (found == levels.end()) continue;
    result.values.push_back(observations.values[row]);
    for (std::size_t k = 0; k < result.factors.size(); ++k)
      result.factors[k].level.push_back(result.factors[k].name == name
                                            ? static_cast<std::size_t>(found - levels.begin())
                                            : observations.factors[k].level[row]);
  }
  for (Factor& factor : result.factors)
    if (factor.name == name) factor.levels = levels;
  return result;
}

std::vector<std::string> met_conditions(const Factor& factor, const std::vector<std::string>& order,
                                        std::vector<std::string>& left_out) {
  std::vector<std::string> met;
  for (const std::string& name : order) {
    const auto level = std::find(factor.levels.begin(), factor.levels.end(), name) - factor.levels.begin();
    if (std::count(factor.level.begin(), factor.level.end(), static_cast<std::size_t>(level)) > 0)
      met.push_back(name);
    else
      left_out.push_back(fmt::format("nobody has a value under {}", name));
  }
  if (met.size() < 2)
    throw StatisticsError(fmt::format("comparisons need two conditions or more; there {}",
                                      met.empty() ? "is none" : "is " + met.front() + " alone"));
  return met;
}

/// Returns the subjects with a value in every cell.
std::vector<std::string> complete_subjects(const Observations& observations, const std::string& subject,
                                           const std::string& condition, std::vector<std::string>& left_out) {
  std::vector<std::string> complete = observations.factor(subject).levels;
  for (const Cell& cell : cells(observations, {subject, condition})) {
    if (!cell.values.empty()) continue;
    const std::string& name = observations.factor(subject).levels[cell.levels[0]];
    left_out.push_back(fmt::format("{} {} has no value under {}", subject, name,
                                   observations.factor(condition).levels[cell.levels[1]]));
    std::erase(complete, name);
  }
  if (complete.size() < 2)
    throw StatisticsError(
        fmt::format("comparisons need two subjects or more with a value under every condition; there is {}{}",
                    complete.empty() ? "none" : "one",
                    left_out.empty() ? "" : fmt::format(" ({})", fmt::join(left_out, "; "))));
  return complete;
}

}  // namespace

std::vector<double> ConditionTable::column(std::size_t condition) const {
  const auto at = values.col(static_cast<Eigen::Index>(condition));
  return {at.begin(), at.end()};
}

std::vector<double> ConditionTable::differences(std::size_t first, std::size_t second) const {
  const Eigen::VectorXd both =
      values.col(static_cast<Eigen::Index>(first)) - values.col(static_cast<Eigen::Index>(second));
  return without_rounding({both.begin(), both.end()}, values.cwiseAbs().maxCoeff());
}

ConditionTable condition_table(const Observations& observations, const std::string& condition,
                               const std::string& subject, const std::vector<std::string>& order) {
  observations.check();
  ConditionTable table;
  table.conditions = met_conditions(observations.factor(condition), order, table.left_out);
  table.observations = kept(observations, condition, table.conditions);
  table.subjects = complete_subjects(table.observations, subject, condition, table.left_out);
  table.observations = kept(table.observations, subject, table.subjects);
  table.values = cell_means(table.observations, {condition}, subject);
  return table;
}

}  // namespace stepwire::statistics

#include "engine/analyse/statistics/grouped.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/analyse/statistics/moments.hpp"

namespace stepwire::statistics {

namespace {

/// Returns the indices of the factors that occur in a term.
std::vector<std::size_t> used_factors(const Observations& observations, const std::vector<Term>& terms) {
  for (const Term& term : terms)
    for (const std::string& name : term.factors) observations.factor(name);  // throws for an unknown one
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < observations.factors.size(); ++k)
    if (std::ranges::any_of(terms, [&](const Term& term) {
          return std::ranges::find(term.factors, observations.factors[k].name) != term.factors.end();
        }))
      used.push_back(k);
  return used;
}

/// Returns the values of each group, and adds the levels of the groups to the factors.
std::vector<std::vector<double>> values_by_group(const Observations& observations,
                                                 const std::vector<std::size_t>& used,
                                                 std::vector<Factor>& factors) {
  std::map<std::vector<std::size_t>, std::size_t> known;
  std::vector<std::vector<double>> values;
  for (std::size_t row = 0; row < observations.values.size(); ++row) {
    std::vector<std::size_t> levels;
    for (const std::size_t k : used) levels.push_back(observations.factors[k].level[row]);
    const auto [group, is_new] = known.emplace(levels, values.size());
    if (is_new) {
      values.emplace_back();
      for (std::size_t i = 0; i < used.size(); ++i) factors[i].level.push_back(levels[i]);
    }
    values[group->second].push_back(observations.values[row]);
  }
  return values;
}

}  // namespace

Grouped grouped(const Observations& observations, const std::vector<Term>& terms) {
  const std::vector<std::size_t> used = used_factors(observations, terms);
  Grouped result;
  result.groups.response = observations.response;
  result.count = static_cast<double>(observations.values.size());
  for (const std::size_t k : used) {
    result.groups.factors.push_back(observations.factors[k]);
    result.groups.factors.back().level.clear();
  }
  const auto values = values_by_group(observations, used, result.groups.factors);
  result.roots.resize(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Moments moments = moments_of(values[i], observations.values[0]);
    result.groups.values.push_back(moments.above);
    result.within += moments.squares;
    result.roots[static_cast<Eigen::Index>(i)] = std::sqrt(static_cast<double>(values[i].size()));
  }
  result.total = moments_of(observations.values).squares;
  return result;
}

}  // namespace stepwire::statistics

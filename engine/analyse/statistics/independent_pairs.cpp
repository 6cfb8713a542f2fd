#include "engine/analyse/statistics/independent_pairs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/distributions.hpp"

namespace stepwire::statistics {
namespace {

struct Group {
  std::string name;
  double above = 0.0, square = 0.0, count = 0.0;  ///< above: mean minus the first value of all; square:
                                                  ///< squared standard error of the mean
};

Group group_of(const Observations& observations, const std::vector<std::string>& factors, const Cell& cell) {
  std::vector<std::string> levels;
  for (std::size_t k = 0; k < factors.size(); ++k)
    levels.push_back(observations.factor(factors[k]).levels[cell.levels[k]]);
  Group group{fmt::format("{}", fmt::join(levels, " ")), 0.0, 0.0, static_cast<double>(cell.values.size())};
  const Moments moments = moments_of(cell.values, observations.values.front());
  group.above = moments.above;
  group.square = moments.squares / (group.count - 1.0) / group.count;
  return group;
}

IndependentPair compared(const Group& a, const Group& b) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  IndependentPair pair{a.name, b.name, a.above - b.above, {none, none}, none, none, none, none};
  const double square = a.square + b.square;
  if (!(square > 0.0)) return pair;
  pair.freedom =
      square * square / (a.square * a.square / (a.count - 1.0) + b.square * b.square / (b.count - 1.0));
  pair.t = pair.difference / std::sqrt(square);
  pair.p = fisher_tail(pair.t * pair.t, 1.0, pair.freedom);
  const double half = student_quantile(0.975, pair.freedom) * std::sqrt(square);
  pair.interval = {pair.difference - half, pair.difference + half};
  return pair;
}

}  // namespace

std::vector<IndependentPair> independent_pairs(const Observations& observations,
                                               const std::vector<std::string>& factors) {
  std::vector<Group> groups;
  for (const Cell& cell : cells(observations, factors))
    if (!cell.values.empty()) groups.push_back(group_of(observations, factors, cell));
  std::vector<IndependentPair> pairs;
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (std::size_t j = i + 1; j < groups.size(); ++j) pairs.push_back(compared(groups[i], groups[j]));
  std::vector<double> probabilities;
  for (const IndependentPair& pair : pairs) probabilities.push_back(pair.p);
  const std::vector<double> corrected = holm_corrected(probabilities);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].holm = corrected[i];
  return pairs;
}

}  // namespace stepwire::statistics

#include "engine/analyse/statistics/observations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::statistics {
namespace {

void check_factor(const Factor& factor, std::size_t count) {
  if (factor.level.size() != count)
    throw StatisticsError(fmt::format("the factor '{}' has {}, the response {}", factor.name,
                                      text::counted(factor.level.size(), "observation"), count));
  for (const std::size_t level : factor.level)
    if (level >= factor.levels.size())
      throw StatisticsError(fmt::format("the factor '{}' has {}, and an observation has level {}",
                                        factor.name, text::counted(factor.levels.size(), "level"),
                                        level + 1));
}

}  // namespace

const Factor& Observations::factor(const std::string& name) const {
  std::vector<std::string> names;
  for (const Factor& factor : factors) {
    if (factor.name == name) return factor;
    names.push_back(factor.name);
  }
  throw StatisticsError(fmt::format("there is no factor '{}'; there are: {}", name, fmt::join(names, ", ")));
}

void Observations::check() const {
  if (values.empty()) throw StatisticsError("there are no observations");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw StatisticsError(fmt::format("the value of observation {} is no finite number", i + 1));
  for (std::size_t i = 0; i < factors.size(); ++i) {
    check_factor(factors[i], values.size());
    for (std::size_t j = 0; j < i; ++j)
      if (factors[i].name == factors[j].name)
        throw StatisticsError(fmt::format("two factors are named '{}'", factors[i].name));
  }
}

Factor make_factor(std::string name, const std::vector<std::string>& words, bool subject) {
  Factor factor{std::move(name), {}, {}, subject};
  for (const std::string& word : words) {
    const auto known = std::find(factor.levels.begin(), factor.levels.end(), word);
    factor.level.push_back(static_cast<std::size_t>(known - factor.levels.begin()));
    if (known == factor.levels.end()) factor.levels.push_back(word);
  }
  return factor;
}

std::vector<Cell> cells(const Observations& observations, const std::vector<std::string>& factors) {
  std::vector<const Factor*> by;
  std::size_t count = 1;
  for (const std::string& name : factors) {
    by.push_back(&observations.factor(name));
    count *= by.back()->levels.size();
  }
  std::vector<Cell> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    for (std::size_t k = by.size(); k-- > 0; rest /= by[k]->levels.size())
      result[i].levels.insert(result[i].levels.begin(), rest % by[k]->levels.size());
  }
  for (std::size_t row = 0; row < observations.values.size(); ++row) {
    std::size_t at = 0;
    for (const Factor* factor : by) at = at * factor->levels.size() + factor->level[row];
    result[at].values.push_back(observations.values[row]);
  }
  return result;
}

std::string cell_name(const Observations& observations, const std::vector<std::string>& factors,
                      const Cell& cell) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < factors.size(); ++i)
    words.push_back(fmt::format("{} {}", factors[i], observations.factor(factors[i]).levels[cell.levels[i]]));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace stepwire::statistics

#include "engine/analyse/study/comparison_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/statistics/no_number.hpp"
#include "engine/analyse/statistics/within_subjects.hpp"

namespace stepwire::study {
namespace {

constexpr const char* quantities[]{"difference", "low",         "high", "p_pair",
                                   "holm",       "signed_rank", "d",    "needed"};

/// Returns the values of one pair, in the order of the quantities.
std::vector<double> values_of(const statistics::PairComparison& one, const statistics::PowerRow& power) {
  return {one.test.mean,
          one.test.interval.low,
          one.test.interval.high,
          one.test.p,
          one.holm,
          one.ranks.p,
          one.effect.d_z,
          power.needed_simulated ? static_cast<double>(*power.needed_simulated) : statistics::no_number};
}

}  // namespace

std::vector<std::string> comparison_columns(const StudyRequest& request) {
  std::vector<std::string> pairs, columns;
  const auto names = request.condition_names();
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t k = i + 1; k < names.size(); ++k) pairs.push_back(names[i] + "_" + names[k]);
  for (const std::string& pair : pairs)
    for (const char* quantity : quantities)
      if (std::count(pairs.begin(), pairs.end(), pair) == 1)
        columns.push_back(fmt::format("{}.{}", quantity, pair));
  return columns;
}

std::vector<NamedValue> comparison_values(const Experiment& experiment, const StudyRequest& request) {
  std::vector<NamedValue> found, values;
  if (experiment.analysis && experiment.analysis->within) {
    const statistics::WithinSubjects& within = *experiment.analysis->within;
    statistics::PowerSimulation simulation;
    simulation.seed = experiment.seed;
    const auto power = statistics::power_rows(within, simulation);
    for (std::size_t i = 0; i < within.comparisons.size(); ++i) {
      const statistics::PairComparison& one = within.comparisons[i];
      const auto numbers = values_of(one, power[i]);
      for (std::size_t k = 0; k < numbers.size(); ++k)
        found.push_back({fmt::format("{}.{}_{}", quantities[k], one.first, one.second), numbers[k]});
    }
  }
  for (const std::string& name : comparison_columns(request)) values.push_back({name, value_of(found, name)});
  return values;
}

}  // namespace stepwire::study

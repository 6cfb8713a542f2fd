#include "engine/analyse/tuning/objective.hpp"

#include <algorithm>
#include <optional>

namespace stepwire::tuning {

namespace {

using RunValues = std::vector<std::optional<double>>;

/// The number of a parameter in a run: each recording has it in all of the run's rows.
double parameter_of(const std::string& name, std::span<const record::Recording> recordings, std::size_t run) {
  const record::Recording& first = recordings.front();
  const table::Column* column = first.table.find(name);
  if (!column || run >= first.starts.size() || first.starts[run] >= column->values.size())
    return query::nothing;
  return column->values[first.starts[run]];
}

/// The numbers that the formula takes of one run; none where a reduction leaves the run out.
std::optional<std::vector<double>> numbers_of(const Objective& objective,
                                              const std::vector<RunValues>& reduced,
                                              std::span<const record::Recording> recordings,
                                              std::size_t run) {
  std::vector<double> numbers;
  for (const std::string& name : objective.formula->columns) {
    const auto found = std::ranges::find(objective.names, name);
    if (found == objective.names.end()) {
      numbers.push_back(parameter_of(name, recordings, run));
      continue;
    }
    const std::optional<double>& value =
        reduced[static_cast<std::size_t>(found - objective.names.begin())][run];
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

}  // namespace

std::vector<std::string> Objective::columns() const {
  std::vector<std::string> all = formula->columns;
  for (const claim::Claim& one : reductions) {
    for (const query::Formula& value : one.values)
      all.insert(all.end(), value.columns.begin(), value.columns.end());
    if (one.where) all.insert(all.end(), one.where->columns.begin(), one.where->columns.end());
  }
  return all;
}

RunValues values_of(const Objective& objective, std::span<const record::Recording> recordings) {
  std::vector<RunValues> reduced;
  std::size_t runs = recordings.empty() ? 0 : recordings.front().starts.size();
  for (const claim::Claim& one : objective.reductions) {
    reduced.push_back(claim::values_of_runs(one, recordings));
    runs = std::min(runs, reduced.back().size());
  }
  RunValues values(runs);
  for (std::size_t run = 0; run < runs; ++run)
    if (const auto numbers = numbers_of(objective, reduced, recordings, run))
      values[run] = objective.formula->expression(*numbers);
  return values;
}

}  // namespace stepwire::tuning

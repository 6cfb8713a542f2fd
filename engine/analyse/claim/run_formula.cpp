#include "engine/analyse/claim/run_formula.hpp"

#include <algorithm>
#include <optional>

namespace stepwire::claim {

namespace {

using RunValues = std::vector<std::optional<double>>;

/// Returns the value of a parameter in a run, from the run's first row: it is the same in all rows.
double parameter_of(const std::string& name, std::span<const record::Recording> recordings, std::size_t run) {
  const record::Recording& first = recordings.front();
  const table::Column* column = first.table.find(name);
  if (!column || run >= first.starts.size() || first.starts[run] >= column->values.size())
    return query::nothing;
  return column->values[first.starts[run]];
}

/// Returns the arguments of the formula for one run; std::nullopt if a reduction selects no row of it.
std::optional<std::vector<double>> numbers_of(const RunFormula& formula,
                                              const std::vector<RunValues>& reduced,
                                              std::span<const record::Recording> recordings,
                                              std::size_t run) {
  std::vector<double> numbers;
  for (const std::string& name : formula.formula->columns) {
    const auto found = std::ranges::find(formula.names, name);
    if (found == formula.names.end()) {
      numbers.push_back(parameter_of(name, recordings, run));
      continue;
    }
    const std::optional<double>& value =
        reduced[static_cast<std::size_t>(found - formula.names.begin())][run];
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

}  // namespace

std::vector<std::string> RunFormula::columns() const {
  std::vector<std::string> all = formula->columns;
  for (const Claim& one : reductions) {
    for (const query::Formula& value : one.values)
      all.insert(all.end(), value.columns.begin(), value.columns.end());
    if (one.where) all.insert(all.end(), one.where->columns.begin(), one.where->columns.end());
  }
  return all;
}

RunValues values_of(const RunFormula& formula, std::span<const record::Recording> recordings) {
  std::vector<RunValues> reduced;
  std::size_t runs = recordings.empty() ? 0 : recordings.front().starts.size();
  for (const Claim& one : formula.reductions) {
    reduced.push_back(values_of_runs(one, recordings));
    runs = std::min(runs, reduced.back().size());
  }
  RunValues values(runs);
  for (std::size_t run = 0; run < runs; ++run)
    if (const auto numbers = numbers_of(formula, reduced, recordings, run))
      values[run] = formula.formula->expression(*numbers);
  return values;
}

}  // namespace stepwire::claim

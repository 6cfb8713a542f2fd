#include "engine/simulate/solve/additions.hpp"

#include <algorithm>

namespace stepwire::solve {

namespace {

/// Returns the rows of a method: those of the stages after the first, then the weights of the result.
std::vector<std::vector<double>> rows_of(const Tableau& tableau) {
  std::vector<std::vector<double>> rows = tableau.a;
  rows.push_back(tableau.b);
  return rows;
}

/// True if a row has a sum to accumulate before its last derivative is known.
bool waits(const std::vector<double>& row) {
  return std::any_of(row.begin(), row.end() - 1, [](double weight) { return weight != 0.0; });
}

}  // namespace

std::vector<SolverStage> stages_of(const Tableau& tableau) {
  std::vector<SolverStage> stages(tableau.b.size());
  for (std::size_t stage = 0; stage < tableau.c.size(); ++stage) stages[stage].next = tableau.c[stage];
  int places = 1;
  for (const auto& row : rows_of(tableau)) {
    const int own = waits(row) ? places++ : Addition::start;
    int from = Addition::start;
    for (std::size_t stage = 0; stage < row.size(); ++stage) {
      const bool last = stage + 1 == row.size();  // needed even if this weight is 0
      if (row[stage] == 0.0 && !last) continue;
      const int to = last ? Addition::states : own;
      stages[stage].additions.push_back({from, to, row[stage]});
      from = to;
    }
  }
  return stages;
}

int places_of(const std::vector<SolverStage>& stages) {
  int most = Addition::start;
  for (const SolverStage& stage : stages)
    for (const Addition& addition : stage.additions) most = std::max(most, addition.to);
  return most + 1;
}

}  // namespace stepwire::solve

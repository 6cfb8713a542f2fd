#include "engine/solve/explicit_solver.hpp"

#include <algorithm>

namespace stepwire {

namespace {

constexpr int states = -1, start = 0;  // places; above are the rows of sums

/// The rows of a method: those of the stages after the first, then the weights of the result.
std::vector<std::vector<double>> rows_of(const Tableau& tableau) {
  std::vector<std::vector<double>> rows = tableau.a;
  rows.push_back(tableau.b);
  return rows;
}

bool waits(const std::vector<double>& row) {
  return std::count_if(row.begin(), row.end(), [](double weight) { return weight != 0.0; }) > 1;
}

// A loop by hand: most diagrams have few states, for which setting up a vector expression costs more than its
// work. What is written is nowhere else read, or the same element.
void add(double* to, const double* from, double weight, const double* __restrict slope, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = from[i] + weight * slope[i];
}

}  // namespace

ExplicitSolver::ExplicitSolver(const Tableau& tableau, std::size_t count) : stages_(tableau.b.size()) {
  for (std::size_t stage = 0; stage < tableau.c.size(); ++stage) stages_[stage].next = tableau.c[stage];
  int places = 1;
  for (const auto& row : rows_of(tableau)) {
    const int own = waits(row) ? places++ : start;
    int from = start;
    for (std::size_t stage = 0; stage < row.size(); ++stage) {
      if (row[stage] == 0.0) continue;
      const int to = stage + 1 == row.size() ? states : own;  // complete, and now wanted
      stages_[stage].additions.push_back({from, to, row[stage]});
      from = to;
    }
  }
  sums_.assign(static_cast<std::size_t>(places) * count, 0.0);
}

double* ExplicitSolver::place(int number, System& system) {
  return number == states ? system.x : sums_.data() + static_cast<std::size_t>(number) * system.count;
}

void ExplicitSolver::use_slope(const Stage& stage, System& system, double step) {
  for (const Addition& addition : stage.additions)
    add(place(addition.to, system), place(addition.from, system), step * addition.weight, system.dot,
        system.count);
}

void ExplicitSolver::advance(System& system, double time, double step) {
  for (std::size_t i = 0; i < system.count; ++i) sums_[i] = system.x[i];
  use_slope(stages_.front(), system, step);
  for (std::size_t stage = 1; stage < stages_.size(); ++stage) {
    *system.time = time + stages_[stage - 1].next * step;
    system.evaluate();
    use_slope(stages_[stage], system, step);
  }
}

}  // namespace stepwire

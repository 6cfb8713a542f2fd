#include "engine/solve/explicit_solver.hpp"

#include <algorithm>

namespace stepwire {

namespace {

template <class Term>
std::vector<Term> without_zeros(const std::vector<double>& weights) {
  std::vector<Term> terms;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] != 0.0) terms.push_back({i, weights[i]});
  return terms;
}

}  // namespace

ExplicitSolver::ExplicitSolver(const Tableau& tableau, std::size_t states)
    : c_(tableau.c), b_(without_zeros<Term>(tableau.b)), start_(states), slopes_(states * tableau.b.size()) {
  for (const auto& row : tableau.a) rows_.push_back(without_zeros<Term>(row));
}

// Loops by hand: most diagrams have few states, for which setting up a vector expression costs more than its
// work.
void ExplicitSolver::combine(double* x, const std::vector<Term>& terms, double step) const {
  const std::size_t count = start_.size();
  const double* from = start_.data();
  for (const Term& term : terms) {
    const double weight = step * term.weight;
    const double* slope = slopes_.data() + term.stage * count;
    for (std::size_t i = 0; i < count; ++i) x[i] = from[i] + weight * slope[i];
    from = x;
  }
}

void ExplicitSolver::advance(System& system, double time, double step) {
  std::copy_n(system.x, system.count, start_.data());
  std::copy_n(system.dot, system.count, slope(0));
  for (std::size_t stage = 0; stage < rows_.size(); ++stage) {
    combine(system.x, rows_[stage], step);
    *system.time = time + c_[stage] * step;
    system.evaluate();
    std::copy_n(system.dot, system.count, slope(stage + 1));
  }
  combine(system.x, b_, step);
}

}  // namespace stepwire

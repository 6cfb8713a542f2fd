#include "engine/solve/explicit_solver.hpp"

namespace stepwire {

namespace {

template <class Term>
std::vector<Term> without_zeros(const std::vector<double>& weights) {
  std::vector<Term> terms;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] != 0.0) terms.push_back({static_cast<Eigen::Index>(i), weights[i]});
  return terms;
}

}  // namespace

ExplicitSolver::ExplicitSolver(const Tableau& tableau, std::size_t states)
    : c_(tableau.c),
      b_(without_zeros<Term>(tableau.b)),
      start_(static_cast<Eigen::Index>(states)),
      slopes_(static_cast<Eigen::Index>(states), static_cast<Eigen::Index>(tableau.b.size())) {
  for (const auto& row : tableau.a) rows_.push_back(without_zeros<Term>(row));
}

void ExplicitSolver::combine(Eigen::Map<Eigen::VectorXd>& x, const std::vector<Term>& terms, double step) const {
  x = start_ + (step * terms.front().weight) * slopes_.col(terms.front().stage);
  for (std::size_t i = 1; i < terms.size(); ++i) x += (step * terms[i].weight) * slopes_.col(terms[i].stage);
}

void ExplicitSolver::advance(System& system, double time, double step) {
  const auto count = static_cast<Eigen::Index>(system.count);
  Eigen::Map<Eigen::VectorXd> x(system.x, count);
  const Eigen::Map<const Eigen::VectorXd> dot(system.dot, count);
  start_ = x;
  slopes_.col(0) = dot;
  for (std::size_t stage = 0; stage < rows_.size(); ++stage) {
    combine(x, rows_[stage], step);
    *system.time = time + c_[stage] * step;
    system.evaluate();
    slopes_.col(static_cast<Eigen::Index>(stage) + 1) = dot;
  }
  combine(x, b_, step);
}

}  // namespace stepwire

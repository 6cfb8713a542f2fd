#include "engine/solve/explicit_solver.hpp"

namespace stepwire {

namespace {

// A loop by hand: most diagrams have few states, for which setting up a vector expression costs more than its
// work. What is written is nowhere else read, or the same element.
void add(double* to, const double* from, double weight, const double* __restrict slope, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = from[i] + weight * slope[i];
}

}  // namespace

ExplicitSolver::ExplicitSolver(const Tableau& tableau, std::size_t states)
    : stages_(stages_of(tableau)), sums_(static_cast<std::size_t>(places_of(stages_)) * states) {}

double* ExplicitSolver::place(int number, System& system) {
  if (number == Addition::states) return system.x;
  return sums_.data() + static_cast<std::size_t>(number) * system.count;
}

void ExplicitSolver::use_slope(const SolverStage& stage, System& system, double step) {
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

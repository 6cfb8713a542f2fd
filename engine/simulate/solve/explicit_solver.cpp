#include "engine/simulate/solve/explicit_solver.hpp"

#include <algorithm>
#include <cstring>

namespace stepwire::solve {

namespace {

/// Vector of two numbers, a type of both g++ and clang. Most diagrams have few states, for which a loop that
/// the compiler vectorises costs more overhead than work.
using Two = double __attribute__((vector_size(16)));

template <class Number>
Number read(const double* place) {
  Number number;
  std::memcpy(&number, place, sizeof(Number));
  return number;
}

/// Computes the sums for the elements at i. The written elements are read nowhere else, or are the same
/// element.
template <class Number, int count, class Sum>
void add_at(const Sum (&sums)[2], const double* slope, std::size_t i) {
  const Number by = read<Number>(slope + i);
  Number results[count];
  for (int k = 0; k < count; ++k) results[k] = read<Number>(sums[k].from + i) + sums[k].weight * by;
  for (int k = 0; k < count; ++k) std::memcpy(sums[k].to + i, &results[k], sizeof(Number));
}

}  // namespace

ExplicitSolver::ExplicitSolver(const Tableau& tableau, std::size_t states)
    : method_(stages_of(tableau)), sums_(static_cast<std::size_t>(places_of(method_)) * states) {
  for (const SolverStage& stage : method_)
    stages_.push_back({std::vector<Pass>((stage.additions.size() + 1) / 2), stage.next});
}

template <int count>
void ExplicitSolver::add(const Sum (&sums)[2], const System& system) const {
  for (const StatePiece& piece : pieces_) {
    std::size_t i = piece.first;
    for (; i + 2 <= piece.end; i += 2) add_at<Two, count>(sums, system.dot, i);
    if (i < piece.end) add_at<double, count>(sums, system.dot, i);
  }
}

ExplicitSolver::Pass ExplicitSolver::pass_of(const Addition* additions, bool two, const System& system,
                                             double length) {
  const auto place = [&](int number) {
    return number == Addition::states ? system.x
                                      : sums_.data() + static_cast<std::size_t>(number) * system.count;
  };
  const auto sum = [&](const Addition& addition) {
    return Sum{place(addition.to), place(addition.from), length * addition.weight};
  };
  return {{sum(additions[0]), two ? sum(additions[1]) : Sum{}}, two};
}

/// Computes places and weights, which are the same at every step of a run.
void ExplicitSolver::prepare(const System& system, double length) {
  for (std::size_t stage = 0; stage < stages_.size(); ++stage) {
    const std::vector<Addition>& additions = method_[stage].additions;
    for (std::size_t i = 0; i < additions.size(); i += 2)
      stages_[stage].passes[i / 2] = pass_of(additions.data() + i, i + 1 < additions.size(), system, length);
  }
  states_ = system.x;
  length_ = length;
}

void ExplicitSolver::use_slope(const Stage& stage, const System& system) const {
  for (const Pass& pass : stage.passes) {
    if (pass.two) {
      add<2>(pass.sums, system);
    } else {
      add<1>(pass.sums, system);
    }
  }
}

void ExplicitSolver::advance(System& system, const TimeStep& step) {
  if (system.x != states_ || step.length != length_) prepare(system, step.length);
  all_ = {0, system.count};
  pieces_ = system.moving.empty() ? std::span(&all_, 1) : std::span(system.moving);
  for (const StatePiece& piece : pieces_)
    std::copy(system.x + piece.first, system.x + piece.end, sums_.data() + piece.first);
  use_slope(stages_.front(), system);
  for (std::size_t stage = 1; stage < stages_.size(); ++stage) {
    *system.time = step.at(stages_[stage - 1].next);
    system.evaluate();
    use_slope(stages_[stage], system);
  }
}

}  // namespace stepwire::solve

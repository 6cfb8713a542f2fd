#include "engine/simulate/solve/solver.hpp"

#include "engine/simulate/solve/explicit_solver.hpp"
#include "engine/simulate/solve/implicit_solver.hpp"

namespace stepwire::solve {

namespace {

using MakeSolver = std::unique_ptr<Solver> (*)(std::size_t states);

struct Entry {
  SolverKind kind;
  Tableau (*tableau)();       ///< null for a method that is not explicit
  ImplicitMethod method{};    ///< of one that is implicit
  MakeSolver make = nullptr;  ///< likewise
};

template <class Method>
std::unique_ptr<Solver> make_implicit(std::size_t states) {
  return std::make_unique<ImplicitSolver<Method>>(states);
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> table = {
      {{"euler", "explicit Euler", 1}, euler_tableau},
      {{"heun", "Heun's method", 2}, heun_tableau},
      {{"bogacki_shampine", "third-order method of Bogacki and Shampine", 3}, bogacki_shampine_tableau},
      {{"rk4", "the classical Runge-Kutta method", 4}, rk4_tableau},
      {{"dormand_prince", "fifth-order method of Dormand and Prince", 5}, dormand_prince_tableau},
      {{"rosenbrock", "linearly implicit, for stiff plants", 2},
       nullptr,
       {"solve::Rosenbrock", "engine/simulate/solve/rosenbrock.hpp"},
       make_implicit<Rosenbrock<>>},
      {{"sdirk", "Alexander's implicit method with Newton's, for stiff plants far from linear", 3},
       nullptr,
       {"solve::Sdirk", "engine/simulate/solve/sdirk.hpp"},
       make_implicit<Sdirk<>>}};
  return table;
}

const Entry* find_entry(const std::string& name) {
  for (const Entry& entry : entries())
    if (entry.kind.name == name) return &entry;
  return nullptr;
}

}  // namespace

const std::vector<SolverKind>& solver_kinds() {
  static const std::vector<SolverKind> kinds = [] {
    std::vector<SolverKind> result;
    for (const Entry& entry : entries()) result.push_back(entry.kind);
    return result;
  }();
  return kinds;
}

std::unique_ptr<Solver> make_solver(const std::string& name, std::size_t states) {
  const Entry* entry = find_entry(name);
  if (!entry) return nullptr;
  if (entry->make) return entry->make(states);
  return std::make_unique<ExplicitSolver>(entry->tableau(), states);
}

bool evaluates_ticks_only(const std::string& name) {
  const auto tableau = find_tableau(name);
  return tableau && tableau->c.empty();
}

std::optional<ImplicitMethod> find_implicit(const std::string& name) {
  const Entry* entry = find_entry(name);
  return entry && entry->make ? std::optional(entry->method) : std::nullopt;
}

std::optional<Tableau> find_tableau(const std::string& name) {
  const Entry* entry = find_entry(name);
  return entry && entry->tableau ? std::optional(entry->tableau()) : std::nullopt;
}

}  // namespace stepwire::solve

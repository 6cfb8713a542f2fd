#include "engine/solve/solver.hpp"

#include "engine/solve/explicit_solver.hpp"
#include "engine/solve/rosenbrock_solver.hpp"

namespace stepwire {

namespace {

struct Entry {
  SolverKind kind;
  Tableau (*tableau)();  ///< null for a method that is not explicit
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> table = {
      {{"euler", "explicit Euler", 1}, euler_tableau},
      {{"heun", "Heun's method", 2}, heun_tableau},
      {{"bogacki_shampine", "third-order method of Bogacki and Shampine", 3}, bogacki_shampine_tableau},
      {{"rk4", "the classical Runge-Kutta method", 4}, rk4_tableau},
      {{"dormand_prince", "fifth-order method of Dormand and Prince", 5}, dormand_prince_tableau},
      {{"rosenbrock", "linearly implicit, for stiff plants", 2}, nullptr}};
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
  if (!entry->tableau) return std::make_unique<RosenbrockSolver>(states);
  return std::make_unique<ExplicitSolver>(entry->tableau(), states);
}

bool evaluates_ticks_only(const std::string& name) {
  const auto tableau = find_tableau(name);
  return tableau && tableau->c.empty();
}

std::optional<Tableau> find_tableau(const std::string& name) {
  const Entry* entry = find_entry(name);
  return entry && entry->tableau ? std::optional(entry->tableau()) : std::nullopt;
}

}  // namespace stepwire

#include "engine/solve/solver.hpp"

#include "engine/solve/explicit_solver.hpp"
#include "engine/solve/rosenbrock_solver.hpp"

namespace stepwire {

namespace {

struct Entry {
  SolverKind kind;
  std::unique_ptr<Solver> (*make)(std::size_t states);
};

template <Tableau (*tableau)()>
std::unique_ptr<Solver> make_explicit(std::size_t states) {
  return std::make_unique<ExplicitSolver>(tableau(), states);
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> table = {
      {{"euler", "explicit Euler", 1}, make_explicit<euler_tableau>},
      {{"heun", "Heun's method", 2}, make_explicit<heun_tableau>},
      {{"bogacki_shampine", "third-order method of Bogacki and Shampine", 3},
       make_explicit<bogacki_shampine_tableau>},
      {{"rk4", "the classical Runge-Kutta method", 4}, make_explicit<rk4_tableau>},
      {{"dormand_prince", "fifth-order method of Dormand and Prince", 5},
       make_explicit<dormand_prince_tableau>},
      {{"rosenbrock", "linearly implicit, for stiff plants", 2},
       [](std::size_t states) -> std::unique_ptr<Solver> {
         return std::make_unique<RosenbrockSolver>(states);
       }}};
  return table;
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
  for (const Entry& entry : entries())
    if (entry.kind.name == name) return entry.make(states);
  return nullptr;
}

}  // namespace stepwire

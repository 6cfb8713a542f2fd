#include "engine/simulate/solve/solver.hpp"

#include "engine/simulate/solve/automatic.hpp"
#include "engine/simulate/solve/dop853.hpp"
#include "engine/simulate/solve/explicit_solver.hpp"
#include "engine/simulate/solve/implicit_solver.hpp"
#include "engine/simulate/solve/radau.hpp"

namespace stepwire::solve {

namespace {

using MakeSolver = std::unique_ptr<Solver> (*)(std::size_t states);
using MakeControlled = std::unique_ptr<Solver> (*)(std::size_t states, const ErrorControl& control);

struct Entry {
  SolverKind kind;
  Tableau (*tableau)() = nullptr;            ///< nullptr for an implicit method
  CalledMethod method{};                     ///< for an implicit method
  MakeSolver make = nullptr;                 ///< for an implicit method
  CalledMethod controlled{};                 ///< for a method with error control
  MakeControlled make_controlled = nullptr;  ///< for a method with error control
};

template <class Method>
std::unique_ptr<Solver> make_implicit(std::size_t states) {
  return std::make_unique<ImplicitSolver<Method>>(states);
}

template <template <int> class Method>
std::unique_ptr<Solver> make_controlled(std::size_t states, const ErrorControl& control) {
  return std::make_unique<ControlledSolver<Method>>(states, control);
}

const std::string folder = "engine/simulate/solve/";

CalledMethod controlled(const std::string& method, const std::string& header) {
  return {"solve::Controlled<solve::" + method + ", {}>", {folder + "error_control.hpp", folder + header}};
}
CalledMethod called(const std::string& method, const std::string& header) {
  return {"solve::" + method + "<{}>", {folder + header}};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> table = {
      {{"euler", "explicit Euler", 1}, euler_tableau},
      {{"heun", "Heun's method", 2}, heun_tableau},
      {{"bogacki_shampine", "third-order method of Bogacki and Shampine", 3, true},
       bogacki_shampine_tableau,
       {},
       nullptr,
       controlled("BogackiShampine", "explicit_pair.hpp"),
       make_controlled<BogackiShampine>},
      {{"rk4", "the classical Runge-Kutta method", 4}, rk4_tableau},
      {{"dormand_prince", "fifth-order method of Dormand and Prince", 5, true},
       dormand_prince_tableau,
       {},
       nullptr,
       controlled("DormandPrince", "explicit_pair.hpp"),
       make_controlled<DormandPrince>},
      {{"dop853", "eighth-order method of Dormand and Prince, with control of the error", 8, true, false},
       nullptr,
       {},
       nullptr,
       controlled("Dop853", "dop853.hpp"),
       make_controlled<Dop853>},
      {{"rosenbrock", "linearly implicit, for stiff plants", 2, true},
       nullptr,
       called("Rosenbrock", "rosenbrock.hpp"),
       make_implicit<Rosenbrock<>>,
       controlled("Rosenbrock", "rosenbrock.hpp"),
       make_controlled<Rosenbrock>},
      {{"sdirk", "Alexander's implicit method with Newton's, for stiff plants far from linear", 3, true},
       nullptr,
       called("Sdirk", "sdirk.hpp"),
       make_implicit<Sdirk<>>,
       controlled("Sdirk", "sdirk.hpp"),
       make_controlled<Sdirk>},
      {{"rodas", "linearly implicit of fourth order, for stiff plants, with control of the error", 4, true,
        false},
       nullptr,
       {},
       nullptr,
       controlled("Rodas", "rodas.hpp"),
       make_controlled<Rodas>},
      {{"radau", "implicit of fifth order, for stiff plants, with control of the error", 5, true, false},
       nullptr,
       {},
       nullptr,
       controlled("Radau", "radau.hpp"),
       make_controlled<Radau>},
      {{"auto", "dormand_prince or dop853, and radau once that turns out stiff, with control of the error", 5,
        true, false},
       nullptr,
       {},
       nullptr,
       controlled("Automatic", "automatic.hpp"),
       make_controlled<Automatic>}};
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

std::unique_ptr<Solver> make_solver(const std::string& name, std::size_t states,
                                    const std::optional<ErrorControl>& control) {
  const Entry* entry = find_entry(name);
  if (!entry) return nullptr;
  if (control) return entry->make_controlled ? entry->make_controlled(states, *control) : nullptr;
  if (entry->make) return entry->make(states);
  return entry->tableau ? std::make_unique<ExplicitSolver>(entry->tableau(), states) : nullptr;
}

bool evaluates_ticks_only(const std::string& name) {
  const auto tableau = find_tableau(name);
  return tableau && tableau->c.empty();
}

std::optional<CalledMethod> find_called(const std::string& name, bool controlled) {
  const Entry* entry = find_entry(name);
  if (!entry) return std::nullopt;
  if (controlled) return entry->make_controlled ? std::optional(entry->controlled) : std::nullopt;
  return entry->make ? std::optional(entry->method) : std::nullopt;
}

std::optional<Tableau> find_tableau(const std::string& name) {
  const Entry* entry = find_entry(name);
  return entry && entry->tableau ? std::optional(entry->tableau()) : std::nullopt;
}

}  // namespace stepwire::solve

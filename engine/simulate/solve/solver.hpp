#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/step_report.hpp"
#include "engine/simulate/solve/tableau.hpp"

namespace stepwire::solve {

/// States from `first` to `end - 1`.
struct StatePiece {
  std::size_t first, end;
};

/// The differential equations of a run, as a solver sees them: x is set, evaluate() fills dot at the time in
/// *time.
class System {
 public:
  virtual ~System() = default;
  virtual void evaluate() = 0;
  /// Is the way ended at this time, up to which a solver that chooses its steps has come?
  virtual bool stops(double /*at*/) { return false; }

  double* time = nullptr;  ///< [s]
  double* x = nullptr;
  double* dot = nullptr;
  std::size_t count = 0;
  std::vector<StatePiece> moving;  ///< where slopes may not be 0 in this step; empty: everywhere
  StepReport report;               ///< where an implicit solver says what is wrong with a step
};

/// A fixed step in time [s]. `end` is the time of the next tick as that will have it, which start + length
/// may miss by a rounding.
struct TimeStep {
  double start, end, length;

  /// The time of a stage, a fraction of the step behind its start.
  double at(double fraction) const { return fraction == 1.0 ? end : start + fraction * length; }
};

/// Advances x over one fixed step. Scratch memory is its own and made once.
class Solver {
 public:
  virtual ~Solver() = default;
  /// x becomes the state at the step's end. On entry dot is already evaluated at its start. Leaves *time as
  /// it pleases.
  virtual void advance(System& system, const TimeStep& step) = 0;
  /// The states at the start of the last step; of those that did not move anything.
  virtual const double* start() const = 0;
};

struct SolverKind {
  std::string name, doc;
  int order;
  bool controls = false;  ///< may it choose the length of its steps?
  bool fixed = true;      ///< may it take the steps of the file as they are?
};

/// The solvers that a diagram file may name: euler, heun, bogacki_shampine, rk4, dormand_prince, rosenbrock,
/// sdirk, and, with control of the error, dop853, rodas, radau and auto.
const std::vector<SolverKind>& solver_kinds();

/// The numbers of an explicit solver; nothing for one that is not explicit, or not known.
std::optional<Tableau> find_tableau(const std::string& name);

/// How code calls a solver whose stages it does not write out: one that is implicit, or controls its error.
struct CalledMethod {
  std::string type;  ///< "solve::Rosenbrock<{}>", with the states in the hole
  std::vector<std::string> headers;
};
/// Nothing for one that is written out, or not known.
std::optional<CalledMethod> find_called(const std::string& name, bool controlled);

/// Does the solver look at the system at ticks alone, never between them?
bool evaluates_ticks_only(const std::string& name);

/// Null for a name that is not known, or does not go with control of the error, or without.
std::unique_ptr<Solver> make_solver(const std::string& name, std::size_t states,
                                    const std::optional<ErrorControl>& control = {});

}  // namespace stepwire::solve

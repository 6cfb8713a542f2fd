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

/// Range of states [first, end).
struct StatePiece {
  std::size_t first, end;
};

/// Differential equations of a run, as a solver uses them. After x and *time are set, evaluate() computes
/// dot.
class System {
 public:
  virtual ~System() = default;
  virtual void evaluate() = 0;
  /// True if the integration ends at this time. Solvers with error control call it after each of their steps.
  virtual bool stops(double /*at*/) { return false; }

  double* time = nullptr;  ///< [s]
  double* x = nullptr;
  double* dot = nullptr;
  std::size_t count = 0;
  std::vector<StatePiece> moving;  ///< Ranges of states whose derivatives may differ from 0 in this step; an
                                   ///< empty list means all.
  StepReport report;               ///< Report of an implicit solver on a failed step.
};

/// Fixed step in time [s]. `end` is the exact time of the next tick; start + length may differ from it by
/// rounding.
struct TimeStep {
  double start, end, length;

  /// Returns the time of a stage at a fraction of the step.
  double at(double fraction) const { return fraction == 1.0 ? end : start + fraction * length; }
};

/// Integrates x over one fixed step. Its scratch memory is allocated once.
class Solver {
 public:
  virtual ~Solver() = default;
  /// Integrates x to the end of the step. On entry dot must be the derivative at its start. *time is left
  /// undefined.
  virtual void advance(System& system, const TimeStep& step) = 0;
  /// Returns the states at the start of the last step; undefined for states that did not change.
  virtual const double* start() const = 0;
};

struct SolverKind {
  std::string name, doc;
  int order;
  bool controls = false;  ///< true if it has error control
  bool fixed = true;      ///< true if it can take fixed steps
};

/// Returns the solvers that a diagram file may name: euler, heun, bogacki_shampine, rk4, dormand_prince,
/// rosenbrock, sdirk, and, with error control, dop853, rodas, radau and auto.
const std::vector<SolverKind>& solver_kinds();

/// Returns the coefficients of an explicit solver; std::nullopt for any other or unknown solver.
std::optional<Tableau> find_tableau(const std::string& name);

/// Call of a solver from generated code, for solvers whose stages are not written out: implicit ones, and
/// those with error control.
struct CalledMethod {
  std::string type;  ///< type with a placeholder for the number of states, "solve::Rosenbrock<{}>"
  std::vector<std::string> headers;
};
/// Returns std::nullopt for a solver that is written out or unknown.
std::optional<CalledMethod> find_called(const std::string& name, bool controlled);

/// True if the solver evaluates the system at ticks only, never between them.
bool evaluates_ticks_only(const std::string& name);

/// Returns nullptr for an unknown name, and for a solver that is used with error control but has none, or the
/// other way round.
std::unique_ptr<Solver> make_solver(const std::string& name, std::size_t states,
                                    const std::optional<ErrorControl>& control = {});

}  // namespace stepwire::solve

#pragma once

#include "engine/simulate/solve/error_control.hpp"
#include "engine/simulate/solve/rosenbrock.hpp"
#include "engine/simulate/solve/sdirk.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::solve {

/// Solver with a method for stiff plants, such as Rosenbrock<>.
template <class Method>
class ImplicitSolver : public Solver {
 public:
  explicit ImplicitSolver(std::size_t states) : method_(static_cast<Eigen::Index>(states)) {}
  void advance(System& system, const TimeStep& step) override {
    method_.advance(system.x, system.dot, system.time, step.start, step.end, step.length, system.report,
                    [&] { system.evaluate(); });
  }
  const double* start() const override { return method_.start(); }

 private:
  Method method_;
};

/// Solver with step size control.
template <template <int> class Method>
class ControlledSolver : public Solver {
 public:
  ControlledSolver(std::size_t states, const ErrorControl& control)
      : method_(static_cast<Eigen::Index>(states)), control_(control), own_(ControlReport::count(states)) {}
  void advance(System& system, const TimeStep& step) override {
    double* const numbers = system.report.numbers ? system.report.numbers : own_.data();
    method_.advance(system.x, system.dot, system.time, step.start, step.end, step.length, control_, numbers,
                    Slopes{system});
  }
  const double* start() const override { return method_.start(); }

 private:
  struct Slopes {
    System& system;
    void operator()() const { system.evaluate(); }
    bool stops(double at) const { return system.stops(at); }
  };

  Controlled<Method> method_;
  ErrorControl control_;
  std::vector<double> own_;  ///< used if a system has no place for a report
};

}  // namespace stepwire::solve

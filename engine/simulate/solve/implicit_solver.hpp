#pragma once

#include "engine/simulate/solve/rosenbrock.hpp"
#include "engine/simulate/solve/sdirk.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::solve {

/// A method for stiff plants, such as Rosenbrock<>.
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

}  // namespace stepwire::solve

#pragma once

#include "engine/solve/rosenbrock.hpp"
#include "engine/solve/solver.hpp"

namespace stepwire {

/// The linearly implicit method for stiff plants.
class RosenbrockSolver : public Solver {
 public:
  explicit RosenbrockSolver(std::size_t states) : method_(static_cast<Eigen::Index>(states)) {}
  void advance(System& system, const TimeStep& step) override {
    method_.advance(system.x, system.dot, system.time, step.start, step.length, [&] { system.evaluate(); });
  }

 private:
  Rosenbrock<> method_;
};

}  // namespace stepwire

#pragma once

#include <string>
#include <vector>

#include "tests/support/ivp/problem.hpp"

namespace stepwire::bench {

/// Cost and result of one way from a problem's start to its end.
struct SolverRun {
  std::string failure;  ///< empty: the end was reached
  std::vector<double> x;
  double digits = 0.0;
  long steps = 0, rejected = 0;
  long calls = 0;        ///< of the problem's function, those for Jacobians among them
  double seconds = 0.0;  ///< of processor time
};

/// Runs a solver of the engine with control of the error.
SolverRun run_engine(const ivp::Problem& problem, const std::string& solver, double relative,
                     double absolute);

/// Runs CVODE of SUNDIALS: BDF with Newton's method and a dense Jacobian by differences on stiff problems,
/// Adams with fixed-point iteration on others.
SolverRun run_cvode(const ivp::Problem& problem, double relative, double absolute);

}  // namespace stepwire::bench

#pragma once

#include <string>
#include <vector>

#include "tests/support/ivp/problem.hpp"

namespace stepwire::bench {

/// Cost and result of one integration from a problem's start to its end.
struct SolverRun {
  std::string failure;  ///< Empty if the end was reached.
  std::vector<double> x;
  double digits = 0.0;
  long steps = 0, rejected = 0;
  long calls = 0;        ///< Evaluations of the problem's function, including those for Jacobians.
  double seconds = 0.0;  ///< Processor time.
};

/// Runs an engine solver with error control.
SolverRun run_engine(const ivp::Problem& problem, const std::string& solver, double relative,
                     double absolute);

/// Runs CVODE of SUNDIALS. Stiff problems use BDF with Newton's method and a dense Jacobian by differences.
/// Others use Adams with fixed-point iteration.
SolverRun run_cvode(const ivp::Problem& problem, double relative, double absolute);

}  // namespace stepwire::bench

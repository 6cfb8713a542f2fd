#pragma once

#include "tests/support/ivp/problem.hpp"

namespace stepwire::bench {

/// Returns the states at the problem's end. Extrapolates the midpoint rule (Gragg, Bulirsch and Stoer;
/// Hairer, Norsett and Wanner, Solving ODEs I, II.9) with mantissas of 64 bits and a tolerance of 1e-16 per
/// step.
std::vector<double> extrapolate(const ivp::Problem& problem);

}  // namespace stepwire::bench

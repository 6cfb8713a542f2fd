#pragma once

#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// A curve over another number.
struct ResponseCurve {
  std::vector<double> x, y;
};

/// What comes out after a step of 1 at the first of one input and one output: over 8 times the slowest time
/// constant of what dies out, or 40 of the fastest where nothing does. Of a sampled system at its samples,
/// at most 2000.
ResponseCurve step_response(const StateSpace& system);

/// Closed-loop poles for a gain from 0 upwards by which the loop is multiplied, branch by branch.
struct RootLocus {
  std::vector<double> gain, real, imaginary, branch;
};
RootLocus root_locus(const StateSpace& system, double feedback);

}  // namespace stepwire::linear

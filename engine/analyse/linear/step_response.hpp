#pragma once

#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// A curve y(x).
struct ResponseCurve {
  std::vector<double> x, y;
};

/// Returns the unit step response of one input and one output. It lasts 8 times the slowest time constant of
/// the decaying modes, or 40 times the fastest one if no mode decays. Rows are as dense as the modes need
/// that have not decayed; extremes of a continuous system between them are rows, too.
ResponseCurve step_response(const StateSpace& system);

/// Closed-loop poles by branch, for a factor of the loop gain from 0 upwards.
struct RootLocus {
  std::vector<double> gain, real, imaginary, branch;
};
RootLocus root_locus(const StateSpace& system, double feedback);

}  // namespace stepwire::linear

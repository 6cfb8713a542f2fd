#pragma once

#include <cstddef>
#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// Computes the unit step response of a continuous system with delays and one input, at `rows` multiples of
/// `interval` [s] from 0 on. The step size divides the first delay, so that jumps that return through that
/// delay are exactly on the grid. A step is exact if the delayed signals are linear within it.
std::vector<double> delayed_step(const StateSpace& system, double interval, std::size_t rows);

}  // namespace stepwire::linear

#pragma once

#include <cstddef>
#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// Computes the output of a continuous system with delays after a step of 1 at its one input, at `rows`
/// multiples of `interval` [s] from 0 on. Steps of equal length, of which the first delay is a whole number,
/// are exact for inputs of delays that are straight within a step. A jump that comes back at its multiples is
/// not smeared.
std::vector<double> delayed_step(const StateSpace& system, double interval, std::size_t rows);

}  // namespace stepwire::linear

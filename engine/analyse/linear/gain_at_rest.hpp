#pragma once

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// Returns the gain at rest of the first input and output: the limit of the response for s from the right to
/// 0, for z from the right to 1. Infinite, with its sign, for a pole there that input and output see. A pole
/// that cancels is none: integrators of which the difference counts, or one that a delay closes. Returns NaN
/// if the limit cannot be determined.
double gain_at_rest(const StateSpace& system);

}  // namespace stepwire::linear

#pragma once

#include <optional>
#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// The same system with each delay as a line of `nodes` states. They are the values along the line at
/// Chebyshev points (D. Breda, S. Maset, R. Vermiglio, "Pseudospectral differencing methods for
/// characteristic roots of delay differential equations", SIAM J. Sci. Comput. 27, 2005).
StateSpace with_lines(const StateSpace& system, Eigen::Index nodes);

/// Of the poles of a system with delays, whose number has no end, those nearest to 0. Each is found by
/// with_lines() and moved to a root of the characteristic equation by Newton's method; those that move far
/// are left out.
std::vector<Complex> delay_poles(const StateSpace& system);

/// The number of poles to the right of the imaginary axis, or on it. Counts how often the determinant
/// det(1 - exp(-s T) G(s)) turns about 0 along the axis, with G the system between its delays. All poles
/// count, however far from 0. Empty if the determinant passes 0, or if a loop of
/// delays alone has a gain of 1 or more.
std::optional<int> count_unstable(const StateSpace& system);

}  // namespace stepwire::linear

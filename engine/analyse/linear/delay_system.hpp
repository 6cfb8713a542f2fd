#pragma once

#include <optional>
#include <vector>

#include "engine/analyse/linear/state_space.hpp"

namespace stepwire::linear {

/// A system whose inputs reach its outputs through the same delays, one after the other:
/// G(s) = rational(s) exp(-s time).
struct DelayChain {
  StateSpace rational;
  double time = 0.0;  ///< Sum of the delays [s].
};

/// Returns the chain of a system of one input and one output; without delays its time is 0. Returns
/// std::nullopt if delays are in parallel or in a loop, or if a path passes them by.
std::optional<DelayChain> delay_chain(const StateSpace& system);

/// Returns the system around one delay: its input is the end of the delay, its output the start. The other
/// delays remain.
StateSpace around_delay(const StateSpace& system, std::size_t delay);

/// Returns the system without the delays that are in no loop. Its poles are the same.
StateSpace with_loops_only(const StateSpace& system);

/// Returns the system with each delay replaced by a line of `nodes` states. The states are the values along
/// the line at Chebyshev points (D. Breda, S. Maset, R. Vermiglio, "Pseudospectral differencing methods for
/// characteristic roots of delay differential equations", SIAM J. Sci. Comput. 27, 2005).
StateSpace with_lines(const StateSpace& system, Eigen::Index nodes);

/// Returns the system with lines for the delays below `longest` [s]; the others remain delays.
StateSpace with_lines_below(const StateSpace& system, double longest, Eigen::Index nodes);

/// Returns the poles nearest to 0 of a system with delays, which has infinitely many. Eigenvalues of
/// with_lines() are the starts of Newton's method on the characteristic equation. A root far from its start
/// is left out.
std::vector<Complex> delay_poles(const StateSpace& system);

inline constexpr int infinitely_many = 1'000'000'000;

/// Returns the number of poles to the right of the imaginary axis, or on it. By the argument principle it is
/// the number of turns of the determinant det(1 - exp(-s T) G(s)) about 0 along the axis. G is the system
/// between its delays. All poles count, however far from 0; a loop of delays alone with a gain of 1 or more
/// has `infinitely_many`. Returns std::nullopt if the determinant passes 0, or if several loops turn too
/// often to be followed.
std::optional<int> count_unstable(const StateSpace& system);

}  // namespace stepwire::linear

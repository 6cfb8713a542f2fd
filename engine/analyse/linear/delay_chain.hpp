#pragma once

#include <optional>

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

}  // namespace stepwire::linear

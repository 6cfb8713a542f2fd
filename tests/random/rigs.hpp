#pragma once

#include "tests/random/bench.hpp"

namespace stepwire::random {

/// Several blocks that make sense only together, added to a bench.

/// A port to the outside, which feeds its default.
void add_input(Bench& bench);
/// A block that begins to do something else a few times in the run.
void add_crossing(Bench& bench);
/// A bus of some signals and a block that passes it on.
void add_bus(Bench& bench);
/// A mass on a spring, with friction, stops, or both.
void add_body(Bench& bench);
/// An integrator whose input is what it was some time ago.
void add_delayed_loop(Bench& bench);

}  // namespace stepwire::random

#pragma once

#include "tests/random/trials.hpp"

namespace stepwire::random {

/// A smaller diagram that breaks the same law, as small as leaving out blocks, keys and wires makes it.
Failure shrunk(Trials& trials, const Failure& failure);

/// Diagrams that have a little less than this one.
std::vector<Sketch> smaller(const Sketch& sketch);

}  // namespace stepwire::random

#pragma once

#include <cstdint>

#include "engine/model/block/registry.hpp"
#include "tests/random/sketch.hpp"

namespace stepwire::random {

/// A diagram that follows from the seed alone: 3 to 25 blocks and what feeds them, of all types of the
/// registry, with parts, buses, guards, loops. Most of them are valid.
Sketch random_sketch(const Registry& registry, std::uint64_t seed);

}  // namespace stepwire::random

#pragma once

#include "engine/model/block/registry.hpp"

namespace stepwire {

/// Adds every block of this folder.
void register_cosimulation(Registry& registry);

}  // namespace stepwire

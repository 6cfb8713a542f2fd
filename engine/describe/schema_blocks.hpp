#pragma once

#include "engine/block/registry.hpp"
#include "engine/table/json.hpp"

namespace stepwire {

/// Adds one definition for each block ("block.Lag"), one for a part, and "block", which picks by the key
/// `block`.
void add_block_definitions(const Registry& registry, Json& definitions);

}  // namespace stepwire

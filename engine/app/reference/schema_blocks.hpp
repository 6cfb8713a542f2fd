#pragma once

#include "engine/base/json/json.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire {

/// Adds one definition for each block ("block.Lag"), one for a part, and "block", which picks by the key
/// `block`.
void add_block_definitions(const Registry& registry, Json& definitions);

}  // namespace stepwire

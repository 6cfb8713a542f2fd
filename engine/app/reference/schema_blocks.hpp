#pragma once

#include "engine/base/json/json.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// Adds a definition for each block ("block.Lag"), one for a part, and "block", which selects among them by
/// the key `block`.
void add_block_definitions(const Registry& registry, json::Json& definitions);

}  // namespace stepwire::reference

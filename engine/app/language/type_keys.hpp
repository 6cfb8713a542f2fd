#pragma once

#include <vector>

#include "engine/base/yaml/key.hpp"
#include "engine/model/block/block_type.hpp"

namespace stepwire::language {

/// Returns the possible keys of a block of this type, from its declaration.
std::vector<yaml::Key> keys_of_type(const BlockType& type);

/// Adds the keys of guards, which all blocks and parts have, unless a key of that name exists.
void add_guard_keys(std::vector<yaml::Key>& keys);

}  // namespace stepwire::language

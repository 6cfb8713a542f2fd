#pragma once

#include <vector>

#include "engine/base/yaml/key.hpp"
#include "engine/model/block/block_type.hpp"

namespace stepwire::language {

/// The keys that a block of this type may have, from its declaration.
std::vector<yaml::Key> keys_of_type(const BlockType& type);

/// Adds what any block or part may have, where that is none of its own keys.
void add_guard_keys(std::vector<yaml::Key>& keys);

}  // namespace stepwire::language

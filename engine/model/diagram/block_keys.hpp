#pragma once

#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire::diagram {

/// Returns every key that a block of this type may have in a file, except `block` itself.
std::vector<std::string> keys_of(const BlockType& type);

/// Returns the key of a state's initial value: `initial` for the only settable state, else `initial_x`.
std::string initial_key(const BlockType& type, const StateSpec& state);

/// Returns the state whose initial value such a key sets; -1 for other keys.
int state_of_key(const BlockType& type, const std::string& key);

/// True for a key of a parameter or a state. An input of the same name takes a signal instead.
bool has_value(const BlockType& type, const std::string& key);

}  // namespace stepwire::diagram

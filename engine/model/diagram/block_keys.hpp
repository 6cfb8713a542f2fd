#pragma once

#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire::diagram {

/// Every key that a block of this type may have in a file, `block` itself aside.
std::vector<std::string> keys_of(const BlockType& type);

/// The key that gives a state its initial value: `initial` for the only settable one, else `initial_x`.
std::string initial_key(const BlockType& type, const StateSpec& state);

/// The state to which such a key gives its initial value, or -1.
int state_of_key(const BlockType& type, const std::string& key);

/// May this key have a value, of a parameter or a state? An input of the same name takes a signal instead.
bool has_value(const BlockType& type, const std::string& key);

}  // namespace stepwire::diagram

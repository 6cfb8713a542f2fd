#pragma once

#include <string_view>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire::diagram {

// Types of the blocks that the loader adds for `enable` and `trigger`. They are not part of the library, but
// a flattened file names them.

const BlockType& guard_type();
const BlockType& condition_type();
const BlockType& guarded_output_type();
/// Returns the type of the blocks that record parameters.
const BlockType& parameter_value_type();

/// Returns all these types.
const std::vector<const BlockType*>& guard_types();
/// Returns one of these types by its name; nullptr if there is none.
const BlockType* find_guard_type(std::string_view name);

}  // namespace stepwire::diagram

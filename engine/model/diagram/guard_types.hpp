#pragma once

#include <string_view>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire::diagram {

// Types of the blocks that the loader adds for `enable` and `trigger`. They are no blocks of the library; a
// flattened file names them.

const BlockType& guard_type();
const BlockType& condition_type();
const BlockType& guarded_output_type();
/// Of what records a parameter.
const BlockType& parameter_value_type();

/// All of them.
const std::vector<const BlockType*>& guard_types();
/// One of them by its name; null if there is none.
const BlockType* find_guard_type(std::string_view name);

}  // namespace stepwire::diagram

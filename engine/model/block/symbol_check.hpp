#pragma once

#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// Checks that the places and signs of a kind's symbol are parameters that it has, so that whatever is
/// declared can be drawn. Throws std::logic_error, which names the kind and the place.
void check_symbol(const BlockType& type);

}  // namespace stepwire

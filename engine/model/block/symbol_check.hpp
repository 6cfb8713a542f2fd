#pragma once

#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// Checks that the placeholders and signs of a symbol name parameters of its kind, so that every declared
/// block can be drawn. Throws std::logic_error that names the kind and the placeholder.
void check_symbol(const BlockType& type);

}  // namespace stepwire

#pragma once

#include <string>

#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// Reference page of a block for a terminal.
std::string block_page(const BlockType& type);

/// Names of all blocks by family, each with the first sentence of its page.
std::string block_list(const Registry& registry);

}  // namespace stepwire::reference

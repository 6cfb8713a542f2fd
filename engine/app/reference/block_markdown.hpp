#pragma once

#include <string>

#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// Returns the reference page of a block in Markdown, with a heading of the given level.
std::string block_markdown(const BlockType& type, int level = 1);

/// Returns one document with an index by family and the pages of all blocks.
std::string blocks_markdown(const Registry& registry);

}  // namespace stepwire::reference

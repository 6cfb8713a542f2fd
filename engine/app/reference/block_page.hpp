#pragma once

#include <string>

#include "engine/app/reference/block_reference.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// Reference page of a block for a terminal.
std::string block_page(const BlockType& type);

/// The same for any page of the kind.
std::string page_text(const BlockReference& sheet);

/// Names of the blocks in whose page a word stands, as block_list(); empty where there is none.
std::string blocks_about(const Registry& registry, const std::string& word);

/// Names of all blocks by family, each with the first sentence of its page.
std::string block_list(const Registry& registry);

}  // namespace stepwire::reference

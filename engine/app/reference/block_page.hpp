#pragma once

#include <string>
#include <vector>

#include "engine/app/reference/block_reference.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// Returns the reference page of a block in Markdown, with a heading of the given level.
std::string block_markdown(const BlockType& type, int level = 1);

/// Returns one document with an index by family and the pages of all blocks.
std::string blocks_markdown(const Registry& registry);

/// Returns the reference page of a block for the terminal.
std::string block_page(const BlockType& type);

/// Returns a reference page of any kind for the terminal.
std::string page_text(const BlockReference& sheet);

/// Returns the blocks whose page contains the word, in the format of block_list(); empty without a match.
std::string blocks_about(const Registry& registry, const std::string& word);

/// Returns the words of all pages and the names of all blocks: a misspelt word of blocks_about() is near one
/// of them.
std::vector<std::string> searched_words(const Registry& registry);

/// Returns the names of all blocks by family, each with the first sentence of its page.
std::string block_list(const Registry& registry);

}  // namespace stepwire::reference

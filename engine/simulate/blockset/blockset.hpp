#pragma once

#include <string>

#include "engine/model/block/registry.hpp"

namespace stepwire::blockset {

/// Adds the blocks of a folder outside of the library. Its sources, one of which defines
/// `void register_blocks(stepwire::Registry&)`, are compiled into one shared library, which is kept in the
/// cache for as long as they, our headers and the compiler are the same, and which stays loaded. The program
/// has to export its symbols. Throws Error with what the compiler says, or where a block has the name of one
/// that is there; EnvironmentError where there is no folder, no compiler or none of our headers.
void load_blockset(const std::string& folder, Registry& registry);

/// Hash of all that decides what the blocks of a folder do: their sources, our headers and the compiler.
/// Throws as load_blockset() does.
std::string blockset_hash(const std::string& folder);

/// Such folders, as $STEPWIRE_BLOCKS lists them, with ':' between.
void load_blocksets_of_environment(Registry& registry);

}  // namespace stepwire::blockset

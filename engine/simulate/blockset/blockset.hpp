#pragma once

#include <string>

#include "engine/model/block/registry.hpp"

namespace stepwire::blockset {

/// Adds the blocks of a folder outside of stepwire.
///
/// Its sources are compiled into one shared library, which stays loaded. One of them must define `void
/// register_blocks(stepwire::Registry&)`. The library is cached and reused while the sources, the headers of
/// stepwire and the compiler are unchanged. The executable must export its symbols. Throws Error with the
/// compiler's messages, and if a block has the name of an existing one. Throws EnvironmentError if the
/// folder, a compiler or the headers are missing.
void load_blockset(const std::string& folder, Registry& registry);

/// Returns a hash of all that affects the blocks of a folder: their sources, the headers of stepwire and the
/// compiler. Throws as load_blockset() does.
std::string blockset_hash(const std::string& folder);

/// Loads the folders in $STEPWIRE_BLOCKS, separated by ':'.
void load_blocksets_of_environment(Registry& registry);

}  // namespace stepwire::blockset

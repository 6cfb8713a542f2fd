#pragma once

#include "engine/model/block/registry.hpp"

namespace stepwire {

/// Returns all blocks of the library.
Registry blocks();

}  // namespace stepwire

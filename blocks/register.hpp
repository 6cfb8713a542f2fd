#pragma once

#include "engine/model/block/registry.hpp"

namespace stepwire {

/// Every block of the library.
Registry all_blocks();

}  // namespace stepwire

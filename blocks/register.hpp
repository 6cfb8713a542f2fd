#pragma once

#include "engine/model/block/registry.hpp"

namespace stepwire {

/// Every block of the library.
Registry blocks();

}  // namespace stepwire

#pragma once

// Include for the set of block types that diagram files may use: `Registry known = blocks();
// known.add<Drag>("own");`
#include "engine/model/block/registry.hpp"

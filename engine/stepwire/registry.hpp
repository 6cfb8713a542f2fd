#pragma once

// The kinds of block that diagram files may use: `Registry known = blocks(); known.add<Drag>("own");`
#include "engine/model/block/registry.hpp"

#pragma once

// For the source of a block: its declaration, and what configure() may ask and set.
#include "engine/model/block/configure.hpp"
#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"
#include "engine/model/block/outline.hpp"

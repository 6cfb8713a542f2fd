#pragma once

// Include for the source of a block: its declaration, and the interface of configure().
#include "engine/model/block/configure.hpp"
#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"
#include "engine/model/block/outline.hpp"

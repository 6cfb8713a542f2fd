#pragma once

// Include for the header of a block: ports, states and parameters as members of a struct.
#include "engine/model/block/block.hpp"

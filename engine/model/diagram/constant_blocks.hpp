#pragma once

#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Returns for each block whether it computes from constants alone. A period of its part does not act on such
/// a block, and gives no rate to those that read it.
std::vector<bool> constant_blocks(const Diagram& diagram);

}  // namespace stepwire::diagram

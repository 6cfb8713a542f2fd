#pragma once

#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Blocks of the file itself whose outputs feed nothing and are not recorded: as notes with their places.
std::vector<yaml::Fault> unread_blocks(const Diagram& diagram);

}  // namespace stepwire::diagram

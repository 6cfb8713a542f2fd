#pragma once

#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// Returns notes, with locations, about blocks of the file itself whose outputs have no reader and are not
/// recorded.
std::vector<yaml::Fault> unread_blocks(const Diagram& diagram);

}  // namespace stepwire::diagram

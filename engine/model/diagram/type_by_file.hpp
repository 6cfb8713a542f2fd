#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/parameters.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

/// The type of a block as its file gives it, where its ports stand in the file that its key `file` names, and
/// `type` itself for all others. Null, and a fault with the line, where the file cannot be used.
const BlockType* type_by_file(const BlockType& type, const yaml::Node& map, const ValueReader& reader,
                              Report& report, const std::string& subject);

}  // namespace stepwire::diagram

#pragma once

#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// The type of a block as its file gives it, where its ports stand in the file that its key `file` names, and
/// `type` itself for all others. Null, a fault with the line, and a name that has failed, where the file cannot be used.
const BlockType* type_by_file(const BlockType& type, const yaml::Entry& entry, Scope& scope, Report& report);

}  // namespace stepwire::diagram

#pragma once

#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Returns the type of a block whose ports are described by the file under its key `file`; `type` itself for
/// all others. For an unusable file it adds a fault with the line, marks the name as failed, and returns
/// nullptr.
const BlockType* type_by_file(const BlockType& type, const yaml::Entry& entry, Scope& scope, Report& report);

}  // namespace stepwire::diagram

#pragma once

#include "engine/base/json/json.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// Returns the JSON schema (draft 2020-12) of diagram files with these blocks, for completion and
/// explanations in editors.
/// It covers the form of a file only. Names, units and sizes are checked on loading.
json::Json diagram_schema(const Registry& registry);

}  // namespace stepwire::reference

#pragma once

#include "engine/base/json/json.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::reference {

/// JSON schema (draft 2020-12) of diagram files with these blocks: an editor completes names and keys from it
/// and shows what they mean. It knows the form of a file; names, units and sizes are checked on loading.
json::Json diagram_schema(const Registry& registry);

}  // namespace stepwire::reference

#pragma once

#include "engine/base/json/json.hpp"
#include "engine/base/yaml/key.hpp"

namespace stepwire::reference {

/// Returns the schema of a key's value, with its explanation.
json::Json key_schema(const yaml::Key& key);

}  // namespace stepwire::reference

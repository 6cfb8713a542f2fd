#pragma once

#include "engine/base/json/json.hpp"
#include "engine/base/yaml/key.hpp"

namespace stepwire::reference {

/// What may stand behind a key, or has its form, with its explanation.
json::Json key_schema(const yaml::Key& key);

}  // namespace stepwire::reference

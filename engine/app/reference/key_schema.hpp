#pragma once

#include "engine/base/json/json.hpp"
#include "engine/base/yaml/key.hpp"

namespace stepwire {

/// What may stand behind a key, or has its form, with its explanation.
Json key_schema(const Key& key);

}  // namespace stepwire

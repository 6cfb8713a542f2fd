#pragma once

#include "engine/base/json/json.hpp"

namespace stepwire {

/// What stands under `scene`.
Json scene_schema();

}  // namespace stepwire

#pragma once

#include "engine/table/json.hpp"

namespace stepwire {

/// What stands under `scene`.
Json scene_schema();

}  // namespace stepwire

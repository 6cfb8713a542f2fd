#pragma once

#include "engine/base/json/json.hpp"

namespace stepwire {

/// What stands under `study`.
Json study_schema();

}  // namespace stepwire

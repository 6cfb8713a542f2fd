#pragma once

#include "engine/table/json.hpp"

namespace stepwire {

/// What stands under `study`.
Json study_schema();

}  // namespace stepwire

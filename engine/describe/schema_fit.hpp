#pragma once

#include "engine/table/json.hpp"

namespace stepwire {

/// What stands under `fit`.
Json fit_schema();

}  // namespace stepwire

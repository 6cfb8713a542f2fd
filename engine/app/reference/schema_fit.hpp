#pragma once

#include "engine/base/json/json.hpp"

namespace stepwire {

/// What stands under `fit`.
Json fit_schema();

}  // namespace stepwire

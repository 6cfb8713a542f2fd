#pragma once

#include "engine/base/json/json.hpp"

namespace stepwire {

/// Adds "figure" (one picture), "panel" and one definition for each plot.
void add_figure_definitions(Json& definitions);

/// Adds "claim".
void add_claim_definition(Json& definitions);

}  // namespace stepwire

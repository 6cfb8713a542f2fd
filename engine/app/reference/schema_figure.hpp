#pragma once

#include "engine/base/json/json.hpp"

namespace stepwire::reference {

/// Adds the definitions of figures: series, plot, panel, panels, figure and one for each kind of plot.
void add_figure_definitions(json::Json& definitions);

}  // namespace stepwire::reference

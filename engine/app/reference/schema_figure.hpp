#pragma once

#include "engine/base/json/json.hpp"

namespace stepwire::reference {

/// Adds the definitions that figures use: series, plot, panel, panels, figure and one for each kind of plot.
void add_figure_definitions(json::Json& definitions);

}  // namespace stepwire::reference
